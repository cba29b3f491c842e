"""Tests that the check of the floors finds just the listed faults in a tree with every fault."""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
expected = (HERE / "bad" / "faults.txt").read_text(encoding="utf-8")
check = subprocess.run([sys.executable, HERE / "floors.py", "check", HERE / "bad"],
                       capture_output=True, text=True, check=False)
if check.returncode != 1 or check.stdout != expected:
    sys.exit(f"exit code {check.returncode}, expected 1; the faults:\n{check.stdout}{check.stderr}")
