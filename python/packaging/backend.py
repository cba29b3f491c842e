"""The backend of builds: that of scikit-build-core, and headers of Boost where there are none."""

from __future__ import annotations

import os
import shlex
import subprocess
from typing import Any

from scikit_build_core import build
from scikit_build_core.build import *  # noqa: F403

NEEDED = b"#include <boost/multiprecision/cpp_int.hpp>\n"


def _requires(found: list[str]) -> list[str]:
    compiler = shlex.split(os.environ.get("CXX", "c++"))
    try:
        run = subprocess.run([*compiler, "-std=c++20", "-E", "-x", "c++", "-"], input=NEEDED,
                             capture_output=True, check=False)
        missing = run.returncode != 0
    except OSError:
        missing = True
    return [*found, "boost-headers>=1.85"] if missing else found


def get_requires_for_build_wheel(config_settings: Any = None) -> list[str]:
    return _requires(build.get_requires_for_build_wheel(config_settings))


def get_requires_for_build_editable(config_settings: Any = None) -> list[str]:
    return _requires(build.get_requires_for_build_editable(config_settings))
