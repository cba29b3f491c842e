"""Tests minksum batch: jobs in order, errors between them, resumed runs, all pairs, its page."""
import contextlib
import fcntl
import json
import math
import os
import pathlib
import pty
import random
import re
import select
import signal
import socket
import stat
import subprocess
import time
from fractions import Fraction

from support import FRAME, PROGRAM, SOURCE, SQUARE, TRIANGLE, Page, ProgramTest, main, run

SLIT = "POLYGON ((0 0, 6 0, 6 4, 4 4, 4 1, 2 1, 2 4, 0 4, 0 0))"


def lines_of(jobs):
    return "".join(json.dumps(job) + "\n" for job in jobs)


def wkt(text):
    return {"wkt": text}


def some_jobs(count, seed=1):
    """Returns jobs of all operations, some of which fail."""
    rng = random.Random(seed)
    shapes = [SQUARE, FRAME, TRIANGLE, SLIT, "POLYGON EMPTY", "LINESTRING (0 0, 1 2)", "POINT (1 1"]
    jobs = []
    for i in range(count):
        operation = rng.choice(["sum", "dilate", "erode", "open", "close", "nfp", "ifp", "depth"])
        job = {"id": i, "operation": operation, "a": wkt(rng.choice(shapes)),
               "b": wkt(rng.choice(shapes))}
        if operation != "depth" and rng.random() < 0.5:
            job["options"] = {"coords": "exact"}
        jobs.append(job)
    return jobs


class BatchTest(ProgramTest):
    def batch(self, jobs, *options, code=0):
        """Returns the results of the jobs from standard output."""
        path = self.file("jobs.jsonl", jobs if isinstance(jobs, (str, bytes)) else lines_of(jobs))
        result = run("batch", path, *options)
        self.assertEqual(result.returncode, code, result.stderr.decode())
        self.assertEqual(result.stderr == b"", code == 0)
        return [json.loads(line) for line in result.stdout.decode().splitlines()]

    def one(self, code=0, **job):
        [result] = self.batch([job], code=code)
        return result


class Jobs(BatchTest):
    def setUp(self):
        super().setUp()
        self.slit = self.file("slit.wkt", SLIT)
        self.square = self.file("square.wkt", SQUARE)

    def test_same_as_subcommands(self):
        for operation, options in (
                ("sum", {}), ("sum", {"coords": "exact", "regularize": True}), ("dilate", {}),
                ("erode", {"tight": True}), ("open", {"tight": False}), ("close", {}),
                ("nfp", {"reference": "1/3,0.5", "coords": "decimal:2", "round": "outside"}),
                ("ifp", {"fill": "evenodd"}), ("nfp", {"coords": "exact"})):
            words = [f"--{k}" if v is True else f"--{k}={v}" for k, v in options.items()
                     if v is not False]
            expected = self.fine(operation, "-q", self.slit, self.square, *words)
            given = self.one(operation=operation, a="slit.wkt", b=wkt(SQUARE), options=options)
            self.assertEqual(given["result"]["wkt"] + "\n", expected, operation)
            options = {**options, "format": "geojson"}
            given = self.one(operation=operation, a="slit.wkt", b="square.wkt", options=options)
            expected = self.fine(operation, "-q", self.slit, self.square, *words, "--format",
                                     "geojson")
            self.assertEqual(given["result"], json.loads(expected))
        depth = self.one(operation="depth", a="slit.wkt", b="square.wkt",
                         options={"along": [1, "2/3"]})
        self.assertEqual(depth["result"], json.loads(self.fine(
            "depth", self.slit, self.square, "--json", "--along", "1,2/3")))

    def test_offset_has_one_operand(self):
        expected = self.fine("offset", self.slit, "--distance", "0.5", "--join", "miter")
        options = {"distance": 0.5, "join": "miter"}
        given = self.one(operation="offset", a="slit.wkt", options=options)
        self.assertEqual(given["result"]["wkt"] + "\n", expected)
        expected = self.fine("offset", self.slit, "--distance=-1/4", "--side", "inside")
        given = self.one(operation="offset", a="slit.wkt",
                         options={"distance": "-1/4", "side": "inside"})
        self.assertEqual(given["result"]["wkt"] + "\n", expected)
        for job, message in (
                ({"operation": "offset", "a": "slit.wkt", "b": "square.wkt", "options": options},
                 "offset has no 'b'"),
                ({"operation": "offset", "a": "slit.wkt"}, "distance"),
                ({"operation": "sum", "a": "slit.wkt"}, "the job has no 'b'")):
            error = self.batch([job], code=2)[0]["error"]
            self.assertEqual(error["code"], "bad-job")
            self.assertIn(message, error["message"])

    def test_combined_sets(self):
        other = self.file("other.wkt", "POLYGON ((1 1, 5 1, 5 5, 1 5, 1 1))")
        for operation in ("union", "intersection", "difference", "symdiff"):
            for options in ({}, {"regularize": True, "coords": "exact"}):
                words = [f"--{k}" if v is True else f"--{k}={v}" for k, v in options.items()]
                expected = self.fine(operation, self.square, other, *words)
                given = self.one(operation=operation, a="square.wkt", b="other.wkt",
                                 options=options)
                self.assertEqual(given["result"]["wkt"] + "\n", expected)
            error = self.one(2, operation=operation, a="square.wkt")["error"]
            self.assertEqual((error["code"], error["message"]), ("bad-job", "the job has no 'b'"))
        error = self.one(2, operation="difference", a="square.wkt", b=wkt("POINT (0 0)"))["error"]
        self.assertEqual(error["code"], "bad-input")
        self.assertIn("b: polylines, points and spikes can only be united", error["message"])

    def test_one_set(self):
        half = ["1/2", 0, 0, 2, "1/3", -1]
        for operation, options, words in (
                ("reflect", {}, []), ("convert", {"coords": "decimal:1"}, ["--coords=decimal:1"]),
                ("transform", {"scale": "1/3", "move": [1, "2/7"], "coords": "exact"},
                 ["--scale=1/3", "--move=1,2/7", "--coords=exact"]),
                ("transform", {"scale": [2, -1], "turn": 90, "about": "1,1"},
                 ["--scale=2,-1", "--turn=90", "--about=1,1"]),
                ("transform", {"affine": half}, ["--affine=1/2,0,0,2,1/3,-1"]),
                ("transform", {"affine": "1/2,0,0,2,1/3,-1"}, ["--affine=1/2,0,0,2,1/3,-1"])):
            expected = self.fine(operation, self.square, *words)
            given = self.one(operation=operation, a="square.wkt", options=options)
            self.assertEqual(given["result"]["wkt"] + "\n", expected, options)
            self.assertNotIn("notes", given)
        turned = run("transform", self.square, "--turn", "10")
        given = self.one(operation="transform", a="square.wkt", options={"turn": 10})
        self.assertEqual(given["result"]["wkt"] + "\n", turned.stdout.decode())
        self.assertEqual(["minksum: %s\n" % note for note in given["notes"]],
                         [turned.stderr.decode()])
        for options, message in (({}, "transform needs --scale, --turn, --affine or --move"),
                                 ({"affine": [1, 2, 3, 4]}, "--affine takes 6 numbers"),
                                 ({"scale": 0}, "its determinant is 0"),
                                 ({"svg": "x.svg"}, "transform has no option 'svg' in a job")):
            error = self.one(2, operation="transform", a="square.wkt", options=options)["error"]
            self.assertEqual(error["code"], "bad-job")
            self.assertIn(message, error["message"])

    def test_how_operands_are_read(self):
        high = wkt("POLYGON Z ((0 0 1, 2 0 1, 2 2 1, 0 0 1))")
        given = self.one(operation="convert", a=high, options={"drop-z": True})
        self.assertEqual(given["result"]["wkt"], "POLYGON ((0 0, 2 0, 2 2, 0 0))")
        self.assertIn("--drop-z", self.one(2, operation="convert", a=high)["error"]["message"])
        table = wkt("a,b\nPOINT (1 2),POINT (3 4)\n")
        given = self.one(operation="convert", a=table, options={"column": "b"})
        self.assertEqual(given["result"]["wkt"], "POINT (3 4)")
        given = self.one(operation="convert", a=wkt("id,geom\n1,POINT (1 2)\n2,\n"))
        self.assertEqual(given["notes"], ["a: 1 of 2 features skipped: 1 has no geometry"])

    def test_options_that_no_job_takes(self):
        # They were ignored in silence.
        point, table = wkt("POINT (1 2)"), wkt("a,b\nPOINT (1 2),POINT (3 4)\n")
        jobs = self.file("jobs.jsonl", lines_of([{"operation": "convert", "a": point}]))
        parts = self.folder / "parts"
        parts.mkdir()
        self.file("parts/part.wkt", SQUARE)
        for option in ("--column b", "--tolerance 1", "--side inside", "--layer A",
                       "--join-ends 1"):
            note = option.split()[0] + " has no effect: nothing that was read is "
            self.fine("batch", jobs, *option.split(), note=note)
            self.fine("batch", "--pairs", parts, *option.split(), note=note)
        self.batch([{"operation": "sum", "a": table, "b": point}], "--column", "b")
        note = "--column has no effect: nothing that was read is a table (CSV, TSV)"
        given = self.one(operation="convert", a=point, options={"column": "b"})
        self.assertEqual(given["notes"], [note])
        far = {"operation": "depth", "a": wkt(SQUARE), "b": wkt("POINT (9 9)")}
        own = {"operation": "convert", "a": point, "options": {"coords": "exact"}}
        depth = self.file("depth.jsonl", lines_of([far, own]))
        self.fine("batch", depth, "--format", "geojson")
        self.fine("batch", depth, "--coords", "decimal:1",
                  note="--coords has no effect: no job takes it")
        # A job of an earlier run may have taken it.
        out = self.folder / "out.jsonl"
        self.fine("batch", jobs, "-o", out, "--column", "b", note=note)
        out.rename(self.folder / "out.jsonl.partial")
        self.fine("batch", jobs, "-o", out, "--column", "b")

    def test_results_depend_on_how_operands_are_read(self):
        jobs = self.file("jobs.jsonl", lines_of([{
            "operation": "convert", "a": wkt("a,b\nPOINT (1 2),POINT (3 4)\n")}]))
        out, partial = self.folder / "out.jsonl", self.folder / "out.jsonl.partial"
        self.fine("batch", jobs, "-o", out, "--column", "b")
        out.rename(partial)
        for other in ("--column=a", "--drop-z", "--tolerance=1", "--side=inside", "--layer=A",
                      "--join-ends=1"):
            self.fails(2, "not the result of this job with these settings", "batch", jobs, "-o",
                       out, *(["--column=b"] if "column" not in other else []), other)
        self.fine("batch", jobs, "-o", out, "--column", "b")

    def test_reference_systems(self):
        here, there = wkt("SRID=4326;POINT (1 2)"), wkt("SRID=3857;POINT (1 2)")
        for operation, options in (("sum", {}), ("sum", {"tight": True}), ("union", {})):
            given = self.one(operation=operation, a=wkt("POINT (0 0)"), b=here, options=options)
            self.assertTrue(given["result"]["wkt"].startswith("SRID=4326;"))
            error = self.one(2, operation=operation, a=here, b=there, options=options)["error"]
            self.assertEqual(error["message"], "b: the reference system EPSG:3857 differs from "
                             "EPSG:4326 of a; transform one of them first")
        given = self.one(operation="convert", a=here, options={"format": "geojson"})
        self.assertIn("4326", given["result"]["crs"]["properties"]["name"])
        self.assertEqual(self.one(operation="convert", a=wkt("POINT (1 2)"))["result"]["wkt"],
                         "POINT (1 2)")

    def test_answers_of_nfp(self):
        given = self.one(operation="nfp", a="slit.wkt", b="square.wkt",
                         options={"at": [[2, 2.5], "-3,0", [1.5, 2]], "reference": [0, 0]})
        self.assertEqual(given["result"]["contacts"], ["touching", "free", "overlapping"])
        given = self.batch([{"operation": "nfp", "a": "slit.wkt", "b": "square.wkt",
                             "options": {"at": [2, 2.5]}}], "--coords", "exact", "-q")
        self.assertEqual(given[0]["result"]["contacts"], ["touching"])

    def test_pairs_of_numbers(self):
        """A pair may be two JSON numbers, two strings or one string; lists of pairs work, too."""
        for operation in ("nfp", "ifp"):
            expected = self.fine(operation, "-q", self.slit, self.square, "--reference", "1/3,1/7")
            for pair in (["1/3", "1/7"], "1/3,1/7"):
                given = self.one(operation=operation, a="slit.wkt", b="square.wkt",
                                 options={"reference": pair})
                self.assertEqual(given["result"]["wkt"] + "\n", expected)
                self.assertEqual(given["reference"], ["1/3", "1/7"])
        expected = json.loads(self.fine("depth", self.slit, self.square, "--json", "--along",
                                        "-1/3,1/7"))
        for pair in (["-1/3", "1/7"], "-1/3,1/7"):
            given = self.one(operation="depth", a="slit.wkt", b="square.wkt",
                             options={"along": pair})
            self.assertEqual(given["result"], expected)
        for at, contacts in (
                (["2", "5/2"], ["touching"]), ([2, "5/2"], ["touching"]), ("2,5/2", ["touching"]),
                (["2,5/2"], ["touching"]), ([["2", "5/2"]], ["touching"]),
                (["2,5/2", "-3,0"], ["touching", "free"]),
                ([["2", "5/2"], "-3,0", [1.5, 2]], ["touching", "free", "overlapping"])):
            given = self.one(operation="nfp", a="slit.wkt", b="square.wkt", options={"at": at})
            self.assertEqual(given["result"]["contacts"], contacts, at)
        for at in (["2"], ["x", "y"], ["2", "3", "4"], ["2", "1,2"], [[1, 2], 3], []):
            error = self.one(2, operation="nfp", a="slit.wkt", b="square.wkt",
                             options={"at": at})["error"]
            self.assertEqual(error["code"], "bad-job")
            self.assertIn("two numbers", error["message"])

    def test_tight_places_of_sums(self):
        mirrored = "POLYGON ((0 0, -2 0, -2 -2, 0 -2, 0 0))"
        given = self.one(operation="sum", a="slit.wkt", b=wkt(mirrored), options={"tight": True})
        self.assertEqual(given["tight"]["wkt"], "LINESTRING (2 1, 2 4)")
        self.assertEqual(list(given), ["job", "digest", "result", "tight"])

    def test_operands_are_exact(self):
        [result] = self.batch('{"operation": "sum", "options": {"coords": "exact"}, "a": {"type": '
                              '"Point", "coordinates": [0.10000000000000000000000000001, '
                              '123456789012345678901234567890]}, "b": {"type": "Feature", '
                              '"properties": {"wkt": "\\"}"}, "geometry": {"type": "Point", '
                              '"coordinates": [1, "1/3"]}}}')
        self.assertEqual(result["result"]["wkt"],
                         "POINT (110000000000000000000000000001/100000000000000000000000000000 "
                         "370370367037037036703703703671/3)")

    def test_operands_that_are_not_valid(self):
        """A note before the result tells of them, and `strict` refuses them."""
        notched = "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (4 2, 9 2, 9 4, 4 4, 4 2))"
        job = {"operation": "sum", "a": wkt(notched), "b": wkt("POINT (0 0)")}
        result = self.one(**job)
        self.assertEqual(result["result"]["wkt"],
                         "POLYGON ((0 0, 6 0, 6 2, 4 2, 4 4, 6 4, 6 6, 0 6, 0 0))")
        [note] = result["notes"]
        for part in ("a: polygon 1, ring 1, vertex 2: edges cross at (6, ", "--fill automatic"):
            self.assertIn(part, note)
        self.assertEqual(list(result)[-1], "result")
        for options in ({"strict": True}, {"fill": "strict"}):
            error = self.one(code=2, options=options, **job)["error"]
            self.assertEqual(error["code"], "bad-input")
            self.assertIn("edges cross at (6, ", error["message"])
        [error] = self.batch([job], "--strict", code=2)
        self.assertEqual(error["error"]["code"], "bad-input")
        [result] = self.batch([{**job, "options": {"strict": False}}], "--fill", "nonzero")
        self.assertIn("--fill nonzero", result["notes"][0])
        self.assertNotIn("notes", self.one(**{**job, "a": wkt(SQUARE)}))

    def test_order_and_ids(self):
        jobs = some_jobs(300)
        jobs[7]["id"] = {"any": ["thing", 1.0, "\\\"}", None]}
        del jobs[9]["id"]
        results = self.batch(jobs, "--threads", 4, code=2)
        self.assertEqual([r["job"] for r in results], list(range(1, 301)))
        self.assertEqual([r.get("id") for r in results], [j.get("id") for j in jobs])
        self.assertTrue(all(("result" in r) != ("error" in r) for r in results))
        failed = sum("error" in r for r in results)
        self.assertGreater(failed, 20)
        message = run("batch", self.folder / "jobs.jsonl").stderr.decode()
        self.assertEqual(message, f"minksum: {failed} of 300 jobs failed\n")

    def test_numbers_of_any_size(self):
        """Numbers of any size are JSON, and an id is repeated as it stands."""
        ids = ["1e999", "-0", "1e-400", "-0.0E+99999", "9" * 5000, '{"a": [1e999, "1e999\\""]}']
        job = ('"operation": "sum", "a": {"type": "Point", "coordinates": [1e400, 0]}, "b": {"wkt": '
               '"POINT (1 1)"}, "options": {"coords": "exact", "format": "geojson"}}\n')
        text = "".join(f'{{"id": {id}, {job}' for id in ids)
        jobs = self.file("jobs.jsonl", text)
        out = self.folder / "out.jsonl"
        self.fine("batch", jobs, "-o", out)
        lines = out.read_text().splitlines()
        for line, id in zip(lines, ids, strict=True):
            point = f'{{"type": "Point", "coordinates": [1{"0" * 399}1,1]}}'
            self.assertIn(f',"id":{id},"result":{point}', line)
        # A run also resumes behind such results.
        out.rename(self.folder / "out.jsonl.partial")
        self.fine("batch", jobs, "-o", out, "--stats", self.folder / "stats.json")
        self.assertEqual(out.read_text().splitlines(), lines)
        self.assertEqual(json.loads((self.folder / "stats.json").read_text())["earlier"], len(ids))
        for id in ("01", "1.", ".5", "+1", "1e", "--1", "1e+", "-", "1-2", "0x1", "Infinity", "NaN",
                   "1 2", "1e5e5", '"\\ud800"', "1e999 1", "tru1"):
            [result] = self.batch(f'{{"id": {id}, "operation": "sum", "a": "", "b": ""}}\n', code=2)
            self.assertEqual(result["error"], {"code": "bad-job", "message":
                             "a job is a JSON object, which this line is not"}, id)

    def test_numbers_of_options(self):
        for options, fragment in (('{"timeout": 1e999}', "--timeout takes seconds"),
                                  ('{"timeout": -0}', "--timeout takes seconds"),
                                  ('{"max-vertices": -0}', "--max-vertices takes a count"),
                                  ('{"max-vertices": 1e3}', "--max-vertices takes a count"),
                                  ('{"max-bytes": 99999999999999999999}', "--max-bytes takes"),
                                  ('{"round": "inside", "round": "outside"}', "'round' is there"),
                                  ('{"tight": true, "tight": false}', "'tight' is there twice"),
                                  ('{"tight": 1e999}', "--tight takes true or false")):
            [result] = self.batch('{"operation": "sum", "a": {"wkt": "POINT (1 1)"}, "b": {"wkt": '
                                  f'"POINT (1 1)"}}, "options": {options}}}\n', code=2)
            self.assertEqual(result["error"]["code"], "bad-job")
            self.assertIn(fragment, result["error"]["message"])
        offset = ('{"operation": "offset", "a": {"wkt": "POINT (1 1)"}, "options": {"join": '
                  '"square", "cap": "square", "coords": "exact", "distance": %s}}\n')
        for distance in ("1e-400", "1e400", "12345678901234567890123456789", "2e-0"):
            self.batch(offset % distance)
        [result] = self.batch(offset % "1e99999", code=2)
        self.assertIn("exponents up to", result["error"]["message"])

    def test_threads_change_nothing(self):
        jobs = self.file("jobs.jsonl", lines_of(some_jobs(500, 2)))
        outputs = {run("batch", jobs, "--threads", n).stdout for n in (1, 2, 4, 7)}
        self.assertEqual(len(outputs), 1)

    def test_errors_do_not_stop_the_rest(self):
        good = {"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)}
        bad = [  # what to change in the good one, the code, and what the message says
            ({"a": "nowhere.wkt"}, "bad-input", "nowhere.wkt: cannot be read: No such file"),
            ({"a": "."}, "bad-input", ".: is no file; jobs read no pipes"),
            ({"a": "pipe"}, "bad-input", "pipe: is no file; jobs read no pipes"),
            ({"a": "/dev/zero"}, "bad-input", "/dev/zero: is no file; jobs read no pipes"),
            ({"a": "-"}, "bad-job", "'a' names no file"),
            ({"a": ""}, "bad-job", "'a' names no file"),
            ({"a": "jobs.jsonl\0.wkt"}, "bad-job", "'a' names no file"),
            ({"b": wkt("POINT (1 x)")}, "bad-input", "b:1:10: "),
            ({"b": wkt(5)}, "bad-job", "'wkt' of 'b' is a string"),
            ({"b": {"type": "Point", "coordinates": [1]}}, "bad-input", "b:1:"),
            ({"b": {}}, "bad-input", "b:1:"),
            ({"b": 5}, "bad-job", "'b' is the path"),
            ({"b": None}, "bad-job", "'b' is the path"),
            ({"operation": "add"}, "bad-job", "there is no operation 'add'; there are sum, dil"),
            ({"operation": 1}, "bad-job", "'operation' is a string"),
            ({"more": 1}, "bad-job", "a job has no member 'more'"),
            ({"options": [1]}, "bad-job", "'options' is an object"),
            ({"options": {"output": "x"}}, "bad-job", "sum has no option 'output' in a job"),
            ({"options": {"svg": "x"}}, "bad-job", "no option 'svg'"),
            ({"options": {"-o": "x"}}, "bad-job", "no option '-o'"),
            ({"options": {"coords": "some"}}, "bad-job", "--coords takes double"),
            ({"options": {"coords": {"a": 1}}}, "bad-job", "--coords takes no such value"),
            ({"options": {"coords": True}}, "bad-job", "--coords"),
            ({"options": {"format": "svg"}}, "bad-job", "--format takes wkt or geojson"),
            ({"options": {"tight": "x"}}, "bad-job", "--tight takes true or false"),
            ({"options": {"tight": "yes"}}, "bad-job", "--tight takes true or false"),
            ({"options": {"tight": "true"}}, "bad-job", "--tight takes true or false"),
            ({"options": {"tight": 1}}, "bad-job", "--tight takes true or false"),
            ({"options": {"tight": [1, 2]}}, "bad-job", "--tight takes true or false"),
            ({"options": {"regularize": "on"}}, "bad-job", "--regularize takes true or false"),
            ({"options": {"coords": False}}, "bad-job", "--coords takes no such value"),
            ({"options": {"fill": "strict"}, "b": wkt("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))")},
             "bad-input", "b: polygon 1, ring 1"),
            ({"options": {"max-segments": 2}}, "limit", "(--max-segments)"),
            ({"options": {"max-vertices": "3"}}, "limit", "(--max-vertices)"),
            ({"operation": "nfp", "b": wkt("POLYGON ((0 0, 1 1, 2 2, 0 0))"),
              "options": {"reference": "centroid"}}, "bad-input", "b: a part without area has no lo"),
            ({"operation": "ifp", "b": wkt("POINT (1 1)"), "options": {"reference": "lower-left"}},
             "bad-input", "b: a part without area has no lower left corner"),
            ({"operation": "erode", "b": wkt("POLYGON EMPTY")}, "bad-input", "b: erosion by an"),
            ({"operation": "depth", "options": {"coords": "exact"}}, "bad-job",
             "depth has no option 'coords'"),
            ({"operation": "depth", "options": {"along": [0, 0]}}, "bad-job", "--along"),
            ({"operation": "depth", "options": {"along": [1]}}, "bad-job", "two numbers")]
        os.mkfifo(self.folder / "pipe")
        jobs = []
        for change, _, _ in bad:
            jobs += [good, {**good, **change}]
        results = self.batch(jobs, code=2)
        self.assertEqual(len(results), len(jobs))
        for result in results[0::2]:
            self.assertEqual(result["result"]["wkt"], "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))")
        for result, (change, code, fragment) in zip(results[1::2], bad):
            with self.subTest(change):
                self.assertEqual(result["error"]["code"], code, result)
                self.assertIn(fragment, result["error"]["message"])

    def test_lines_that_are_no_jobs(self):
        good = json.dumps({"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)})
        lines = ["{", "[]", "5", '"x"', "# a comment", good + good, good[:-1], "\x00", "{}",
                 '{"operation": "sum", "a": {"wkt": "POINT (0 0)"}}',
                 '{"operation": "sum", "operation": "sum"}', "[" * 100000]
        results = self.batch("\n".join(lines) + "\n" + good, code=2)
        self.assertEqual([r["error"]["code"] for r in results[:-1]], ["bad-job"] * len(lines))
        self.assertIn("result", results[-1])
        # Bytes that are not UTF-8 are no job either, but the answer is JSON all the same.
        for line in (b'{"operation": "\xff"}', b'\xff', b'{"id": "\xc3"}'):
            [result] = self.batch(line + b"\n", code=2)
            self.assertEqual(result["error"]["code"], "bad-job")

    def test_ends_of_lines(self):
        job = json.dumps({"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)})
        plain = self.batch(f"{job}\n{job}\n")
        self.assertEqual(self.batch(f"{job}\r\n{job}\r\n"), plain)
        self.assertEqual(self.batch(f"{job}\n{job}"), plain)
        self.assertEqual(self.batch(f"\ufeff{job}\n{job}\n\n \t\r\n"), plain)
        spread = self.batch(f"\n\n{job}\n\n{job}\n")
        self.assertEqual([r["job"] for r in spread], [3, 5])
        for nothing in ("", "\n", "\r\n \n"):
            self.assertEqual(self.batch(nothing), [])

    def test_huge_line(self):
        job = {"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)}
        huge = {**job, "id": "x" * 300_000}
        results = self.batch([job, huge, job], "--max-bytes", "100K", code=2)
        self.assertEqual([r.get("error", {}).get("code") for r in results], [None, "limit", None])
        self.assertIn("--max-bytes", results[1]["error"]["message"])
        self.assertEqual(len(self.batch([job, huge, job])), 3)

    def test_defaults_for_all_jobs(self):
        job = {"operation": "sum", "a": wkt("POINT (1/3 0)"), "b": wkt("POINT (0 0)")}
        depth = {"operation": "depth", "a": wkt(SQUARE), "b": wkt(SQUARE)}
        results = self.batch([job, {**job, "options": {"coords": "decimal:1"}}, depth],
                             "--coords", "exact", "--format", "geojson")
        self.assertEqual(results[0]["result"]["coordinates"], ["1/3", 0])
        self.assertEqual(results[1]["result"]["coordinates"], [0.3, 0.0])
        self.assertEqual(results[2]["result"]["distance"], 2)

    def test_time_limit_of_a_job(self):
        quick = {"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)}
        # This sum would take minutes, because nearly all of its segments cross.
        corners = [(round(r * math.cos(math.pi * i / 150)), round(r * math.sin(math.pi * i / 150)))
                   for i in range(300) for r in [5000 if i % 2 else 100000]]
        star = "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in [*corners, corners[0]]) + "))"
        slow = {"operation": "sum", "a": wkt(star), "b": wkt(star), "options": {"method": "signed"}}
        limited = {**slow, "options": {"method": "signed", "timeout": 0.05}}
        results = self.batch([quick, limited, quick, slow], "--timeout", "0.5", code=2)
        self.assertEqual([r.get("error", {}).get("code") for r in results],
                         [None, "timeout", None, "timeout"])
        self.assertIn("0.05 seconds", results[1]["error"]["message"])

    def test_standard_input(self):
        jobs = lines_of(some_jobs(50))
        path = self.file("jobs.jsonl", jobs)
        self.assertEqual(run("batch", "-", stdin=jobs).stdout, run("batch", path).stdout)

    def test_answer_before_the_next_question(self):
        process = subprocess.Popen([PROGRAM, "batch", "-"], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE)
        for i in range(5):
            process.stdin.write(lines_of([{"id": i, "operation": "sum", "a": wkt(SQUARE),
                                           "b": wkt(TRIANGLE)}]).encode())
            process.stdin.flush()
            readable, _, _ = select.select([process.stdout], [], [], 60)
            self.assertTrue(readable)
            self.assertEqual(json.loads(process.stdout.readline())["id"], i)
        self.assertEqual(process.communicate()[0], b"")
        self.assertEqual(process.returncode, 0)

    def test_statistics(self):
        stats = self.folder / "stats.json"
        self.batch(some_jobs(60), "--stats", stats, "--threads", 2, code=2)
        found = json.loads(stats.read_text())
        self.assertEqual((found["jobs"], found["threads"], found["earlier"]), (60, 2, 0))
        self.assertGreater(found["failed"], 0)

    def test_help_names_all_operations(self):
        text = self.fine("batch", "--help")
        error = self.one(2, operation="none", a="-", b="-")["error"]["message"]
        names = error.split("there are ")[1].split(", ")
        self.assertEqual(len(names), 16)
        listed = text.split('"operation" (')[1].split(")")[0]
        self.assertEqual(listed.replace("\n", " ").split(", "), names)

    def test_wrong_usage(self):
        jobs = self.file("jobs.jsonl", "")
        self.fails(1, "either JOBS or --pairs", "batch")
        self.fails(1, "either JOBS or --pairs", "batch", jobs, "--pairs", self.folder)
        self.fails(1, "need --pairs", "batch", jobs, "--rotations", 4)
        self.fails(1, "--threads", "batch", jobs, "--threads", 0)
        self.fails(1, "--format", "batch", jobs, "--format", "svg")
        self.fails(1, "same file", "batch", jobs, "-o", jobs)
        out = self.folder / "out"
        for name in ("out", "out.partial", "./out"):
            self.fails(1, "same file", "batch", jobs, "-o", out, "--stats", name, cwd=self.folder)
        for option, path in (("-o", "./jobs.jsonl"), ("--stats", "jobs.jsonl"), ("-o", "link")):
            (self.folder / "link").unlink(missing_ok=True)
            (self.folder / "link").symlink_to(jobs)
            self.fails(1, "same file", "batch", jobs, option, path, cwd=self.folder)
        partial = self.file("more.partial", "")
        self.fails(1, "same file", "batch", partial, "-o", self.folder / "more", "--restart")
        self.fails(2, "nowhere: cannot be read", "batch", "nowhere")
        self.fails(2, "cannot be read", "batch", self.folder)
        self.fails(2, "there is no folder", "batch", jobs, "-o", self.folder / "no" / "out")
        self.fails(2, "cannot be written", "batch", jobs, "-o", self.folder)
        full = self.file("full.jsonl", lines_of(some_jobs(50)))
        self.fails(2, "cannot be written: No space", "batch", full, "-o", "/dev/full")

    def test_progress_on_a_terminal_only(self):
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, "batch", "-"], stdin=subprocess.PIPE, stderr=theirs,
                                   stdout=subprocess.DEVNULL)
        job = lines_of([{"operation": "sum", "a": wkt(SQUARE), "b": wkt(SQUARE)}] * 3).encode()
        for _ in range(3):
            process.stdin.write(job)
            process.stdin.flush()
            time.sleep(0.3)
        process.stdin.close()
        self.assertEqual(process.wait(60), 0)
        os.close(theirs)
        parts = []
        with contextlib.suppress(OSError):  # Linux says so when the other end is closed
            while part := os.read(ours, 65536):
                parts.append(part)
        shown = b"".join(parts).decode()
        os.close(ours)
        self.assertIn(" jobs, 0 failed", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"))

    def test_parts_that_rounding_loses(self):
        # They vanished in silence.
        grain = wkt("POLYGON ((0 0, 0.1 0, 0 0.1, 0 0))")
        lost = ("rounding loses 1 of 1 polygons, which vanish or become one with others "
                "(--coords exact keeps all)")
        options = {"coords": "decimal:0"}
        for operation in ("sum", "dilate", "nfp", "union"):
            job = {"operation": operation, "a": grain, "b": grain}
            self.assertEqual(self.one(options=options, **job)["notes"], [lost])
            self.assertNotIn("notes", self.one(**job))
        for operation, more in (("offset", {"distance": "0.1", "tolerance": "0.01"}),
                                ("convert", {}), ("reflect", {}), ("transform", {"move": "1,0"})):
            made = self.one(operation=operation, a=grain, options={**options, **more})
            self.assertEqual(made["notes"], [lost])
        bow_tie = wkt("POLYGON ((0 0, 0.1 0.1, 0.1 0, 0 0.1, 0 0))")
        notes = self.one(operation="convert", a=bow_tie, options=options)["notes"]
        self.assertEqual((len(notes), "edges cross" in notes[0], "loses" in notes[1]),
                         (2, True, True))
        # A job that fails between two others takes nothing from them.
        found = self.batch([{"operation": "convert", "a": grain, "options": options},
                            {"operation": "erode", "a": wkt("POLYGON ((0 0"), "b": grain},
                            {"operation": "convert", "a": wkt(SQUARE), "options": options}],
                           "--threads", "1", code=2)
        self.assertEqual(["notes" in job for job in found], [True, False, False])
        folder = self.folder / "grains"
        folder.mkdir()
        (folder / "grain.wkt").write_text(grain["wkt"])
        for more, count in ((["--coords", "decimal:0"], 1), ([], 0)):
            made = json.loads(self.fine("batch", "--pairs", folder, "--operation", "nfp", *more))
            self.assertEqual(made.get("notes", []), [lost] * count)


class GoingOn(BatchTest):
    def setUp(self):
        super().setUp()
        self.jobs = self.file("jobs.jsonl", lines_of(some_jobs(400, 3)))
        self.out = self.folder / "out.jsonl"
        self.partial = self.folder / "out.jsonl.partial"
        self.whole = run("batch", self.jobs).stdout

    def finish(self, *options):
        result = run("batch", self.jobs, "-o", self.out, *options)
        self.assertEqual(result.returncode, 2)  # because some jobs fail
        self.assertEqual(self.out.read_bytes(), self.whole)
        self.assertFalse(self.partial.exists())
        return result.stderr

    def test_file_is_what_standard_output_gets(self):
        message = self.finish()
        self.assertIn(b" of 400 jobs failed", message)
        self.out.write_text("old")
        link = self.folder / "link"
        link.symlink_to(self.out)
        run("batch", self.jobs, "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(self.out.read_bytes(), self.whole)

    def test_goes_on_from_any_place(self):
        rng = random.Random(4)
        ends = [i + 1 for i, byte in enumerate(self.whole) if byte == 10]
        message = self.finish()
        for cut in [0, 1, ends[0] - 1, ends[0], ends[0] + 1, ends[-1] - 1, ends[-1],
                    *rng.sample(range(len(self.whole)), 20)]:
            self.partial.write_bytes(self.whole[:cut])
            self.assertEqual(self.finish(), message)
        self.partial.write_bytes(self.whole[:ends[99]])
        self.finish("--stats", self.folder / "stats.json")
        self.assertEqual(json.loads((self.folder / "stats.json").read_text())["earlier"], 100)

    def test_does_not_do_again_what_is_done(self):
        # A result that no run would give, but that has the right head, stays.
        lines = self.whole.splitlines(keepends=True)
        head = re.match(rb'\{"job":1,"digest":"[0-9a-f]+"', lines[0]).group()
        lines[0] = head + b',"result":"kept"}\n'
        self.partial.write_bytes(lines[0])
        run("batch", self.jobs, "-o", self.out)
        self.assertEqual(self.out.read_bytes(), b"".join(lines))

    def test_kill_at_any_moment(self):
        star = str(SOURCE / "examples" / "star.wkt")
        self.jobs.write_text(lines_of([{"id": i, "operation": "sum", "a": star, "b": star}
                                       for i in range(150)] + some_jobs(20)))
        self.whole = run("batch", self.jobs).stdout
        rng = random.Random(5)
        unfinished = 0
        for way in (signal.SIGKILL, signal.SIGINT, signal.SIGTERM):
            for _ in range(5):
                process = subprocess.Popen([PROGRAM, "batch", self.jobs, "-o", self.out],
                                           stderr=subprocess.DEVNULL)
                size = rng.randrange(len(self.whole) // 2)
                while process.poll() is None and not (
                        self.partial.exists() and self.partial.stat().st_size >= size):
                    time.sleep(0.0005)
                process.send_signal(way)
                self.assertIn(process.wait(60), (-way, 2))
                if self.partial.exists():
                    unfinished += 1
                    self.assertTrue(self.whole.startswith(self.partial.read_bytes()))
            self.finish()
            self.out.unlink()
        self.assertGreater(unfinished, 3)

    def test_other_jobs_or_settings(self):
        lines = self.whole.splitlines(keepends=True)
        self.partial.write_bytes(b"".join(lines[:10]))
        changed = some_jobs(400, 3)
        changed[4]["id"] = "another"
        other = self.file("other.jsonl", lines_of(changed))
        refusals = [(5, [other]), (1, [self.jobs, "--coords", "decimal:3"]),
                    (1, [self.jobs, "--max-segments", "1M"])]
        for line, arguments in refusals:
            self.fails(2, f"out.jsonl.partial:{line}: not the result of this job with these "
                          "settings; --restart starts afresh", "batch", *arguments, "-o", self.out)
            self.assertEqual(self.partial.read_bytes(), b"".join(lines[:10]))
        for content in (lines[1], lines[0][:60] + b"\n", self.whole + lines[0],
                        lines[0] + lines[0][:30], self.whole + b'{"job":'):
            self.partial.write_bytes(content)
            self.fails(2, "--restart", "batch", self.jobs, "-o", self.out)
            self.assertEqual(self.partial.read_bytes(), content)
        self.finish("--restart")

    def test_what_no_run_has_left(self):
        """A file that has that name by chance is never lost."""
        result = self.whole.splitlines(keepends=True)[0]
        for content, line in ((b"precious\n", 1), (b"precious", 1), (b"\0\xff", 1), (b"\n", 1),
                              (result + b"precious", 2), (result + b'{"job": 2}\n', 2),
                              (b'{"job":1,"name":', 1), (b'{"job":"1"', 1)):
            self.partial.write_bytes(content)
            for restart in ([], ["--restart"]):
                self.fails(2, f"out.jsonl.partial:{line}: not a line that a run has left; move the "
                              "file away", "batch", self.jobs, "-o", self.out, *restart)
                self.assertEqual(self.partial.read_bytes(), content)
                self.assertFalse(self.out.exists())
        self.partial.write_bytes(result + result[:20])
        self.finish("--restart")

    def test_what_is_no_file(self):
        """Links are not followed, and the program never waits for the other end of a pipe."""
        target = self.file("target", "")
        nowhere = self.folder / "nowhere"
        makers = (lambda: self.partial.symlink_to(target), lambda: self.partial.symlink_to(nowhere),
                  lambda: self.partial.symlink_to("/dev/null"), lambda: os.mkfifo(self.partial),
                  self.partial.mkdir, lambda: os.link(target, self.partial))
        for make in makers:
            make()
            before = os.lstat(self.partial)
            for restart in ([], ["--restart"]):
                self.fails(2, "out.jsonl.partial: ", "batch", self.jobs, "-o", self.out, *restart)
                self.fails(2, "move it away, or name another file with -o", "batch", self.jobs, "-o",
                           self.out, *restart)
            self.assertEqual(os.lstat(self.partial).st_ino, before.st_ino)
            self.assertEqual((target.read_text(), nowhere.exists()), ("", False))
            self.partial.rmdir() if self.partial.is_dir() else self.partial.unlink()
        with socket.socket(socket.AF_UNIX) as there:
            there.bind(str(self.partial))
            self.fails(2, "move it away", "batch", self.jobs, "-o", self.out)
        self.partial.unlink()
        link = self.folder / "link.jsonl"
        link.symlink_to(self.out)
        self.partial.mkdir()
        self.fails(2, f"{self.partial}: is no file", "batch", self.jobs, "-o", link)

    def test_rights(self):
        """The output gets the rights of the old file; before that, only the owner can read it."""
        self.out.write_text("old")
        self.out.chmod(0o6640)
        self.partial.write_bytes(b"")
        self.finish()
        self.assertEqual(stat.S_IMODE(self.out.stat().st_mode), 0o640)
        self.fails(2, "No space left", "batch", self.jobs, "-o", self.out, "--stats", "/dev/full")
        self.assertEqual(stat.S_IMODE(self.partial.stat().st_mode), 0o600)

    def test_old_file_stays_if_statistics_fail(self):
        self.out.write_text("old")
        self.fails(2, "No space left", "batch", self.jobs, "-o", self.out, "--stats", "/dev/full")
        self.assertEqual(self.out.read_text(), "old")
        self.assertEqual(self.partial.read_bytes(), self.whole)
        self.finish()

    def test_one_run_at_a_time(self):
        with open(self.partial, "wb") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            self.fails(2, "another run is writing it", "batch", self.jobs, "-o", self.out)
        self.finish()

    def test_old_file_stays_until_the_end(self):
        self.out.write_text("old")
        self.partial.write_bytes(self.whole[:100] + b"\n")
        self.fails(2, "--restart", "batch", self.jobs, "-o", self.out)
        self.assertEqual(self.out.read_text(), "old")
        self.finish("--restart")


def parsed(text):
    """Returns the rings of a POLYGON."""
    return [[tuple(map(Fraction, point.split())) for point in ring.split(",")]
            for ring in re.findall(r"\(([^()]+)\)", text)]


def polygon(rings):
    return "POLYGON (" + ", ".join(
        "(" + ", ".join(f"{x} {y}" for x, y in ring) + ")" for ring in rings) + ")"


class Pairs(BatchTest):
    def setUp(self):
        super().setUp()
        self.parts = self.folder / "parts"
        self.parts.mkdir()
        self.texts = {"b.wkt": SLIT, "a.wkt": "POLYGON ((2 2, 0 2, 0 0, 2 0, 2 2))",
                      "c.wkt": FRAME, "d.wkt": "POLYGON ((1/3 0, 2.5 1, 0 7/2, 1 1, 1/3 0))"}
        for name, text in self.texts.items():
            (self.parts / name).write_text(text)
        (self.parts / "notes.txt").write_text("no part")

    def pairs(self, *options):
        return [json.loads(line) for line in
                self.fine("batch", "--pairs", self.parts, *options).splitlines()]

    def test_names_of_parts(self):
        wanted = self.pairs()
        (self.parts / "._a.wkt").write_bytes(b"\0\5\x16\7")  # as macOS puts beside a file
        (self.parts / "d.wkt").rename(self.parts / "d.WKT")
        self.assertEqual([r["result"] for r in self.pairs()], [r["result"] for r in wanted])

    def test_parts_that_do_not_fit(self):
        (self.parts / "e.wkt").write_text("SRID=4326;" + FRAME)
        self.assertTrue(all(r["result"]["wkt"].startswith("SRID=4326;") for r in self.pairs()))
        (self.parts / "f.wkt").write_text("SRID=3857;" + FRAME)
        self.fails(2, "the reference system EPSG:3857 differs from EPSG:4326", "batch", "--pairs",
                   self.parts)
        (self.parts / "f.wkt").unlink()
        (self.parts / "f.wkt").symlink_to("nowhere")
        self.fails(2, "f.wkt: cannot be read", "batch", "--pairs", self.parts)

    # Each result equals that of `minksum nfp` for a file with the second part turned.
    def test_same_as_nfp(self):
        for rotations, style in ((1, "double"), (4, "exact"), (3, "exact"), (8, "decimal:3")):
            results = self.pairs("--rotations", rotations, "--tight", "--coords", style)
            names = sorted(self.texts)
            self.assertEqual([(r["fixed"], r["moving"], r["turn"]) for r in results],
                             [(f, m, Fraction(360 * k, rotations)) for f in names for m in names
                              for k in range(rotations)])
            for result in results:
                turned = self.turned(result)
                expected = self.fine("nfp", "-q", self.parts / result["fixed"], turned, "--coords", style)
                self.assertEqual(result["result"]["wkt"] + "\n", expected)
                first = turned.read_text().split("((")[1].split(",")[0]
                self.assertEqual(" ".join(result["reference"]), first)

    def turned(self, result):
        """Returns a file with the moving part of a result, turned."""
        angle = result["turn"]
        if "half_tangent" in result:
            t = Fraction(result["half_tangent"])
            cos, sin = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        else:
            self.assertEqual(angle % 90, 0)
            cos, sin = [(1, 0), (0, 1), (-1, 0), (0, -1)][angle // 90]
        rings = parsed(self.texts[result["moving"]])
        return self.file("turned.wkt", polygon(
            [[(cos * x - sin * y, sin * x + cos * y) for x, y in ring] for ring in rings]))

    # This uses real nesting parts, if there are any.
    def test_same_as_nfp_on_real_parts(self):
        data = os.environ.get("MINKSUM_DATA")
        if not data:
            self.skipTest("MINKSUM_DATA is not set")
        rng = random.Random(7)
        for instance in ("swim", "jakobs1", "gardeyn1"):
            for name in self.texts:
                (self.parts / name).unlink()
            self.texts = {path.name: path.read_text().strip()
                          for path in pathlib.Path(data, "nesting").glob(instance + "_*.wkt")}
            self.assertGreater(len(self.texts), 5)
            for name, text in self.texts.items():
                (self.parts / name).write_text(text)
            results = self.pairs("--rotations", 4, "--tight", "--coords", "exact")
            self.assertEqual(len(results), 4 * len(self.texts) ** 2)
            for result in rng.sample(results, 10):
                expected = self.fine("nfp", "-q", self.parts / result["fixed"], self.turned(result),
                                     "--coords", "exact")
                self.assertEqual(result["result"]["wkt"] + "\n", expected)

    def test_angles(self):
        for rotations in (3, 5, 7, 12, 360, 3600):
            # One part is enough.
            for name in ("b.wkt", "c.wkt", "d.wkt"):
                (self.parts / name).unlink(missing_ok=True)
            results = self.pairs("--rotations", rotations)
            self.assertEqual(len(results), rotations)
            for k, result in enumerate(results):
                self.assertEqual("half_tangent" in result, 4 * k % rotations != 0)
                if "half_tangent" in result:
                    angle = 2 * math.atan(Fraction(result["half_tangent"])) % (2 * math.pi)
                    self.assertLess(abs(angle - 2 * math.pi * k / rotations), 1e-5)

    def test_without_tight_places(self):
        with_tight = {(r["fixed"], r["moving"]): r["result"]["wkt"] for r in self.pairs("--tight")}
        for result in self.pairs():
            self.assertNotIn("LINESTRING", result["result"]["wkt"])
            self.assertIn(result["result"]["wkt"], with_tight[result["fixed"], result["moving"]])
        self.assertIn("LINESTRING", with_tight["b.wkt", "a.wkt"])

    def test_sums(self):
        for result in self.pairs("--operation", "sum", "--coords", "exact"):
            self.assertNotIn("reference", result)
            self.assertEqual(result["result"]["wkt"] + "\n", self.fine(
                "sum", self.parts / result["fixed"], self.parts / result["moving"], "--coords",
                "exact"))

    def test_threads_and_going_on(self):
        options = ["--pairs", self.parts, "--rotations", 24]
        whole = run("batch", *options, "--threads", 1).stdout
        self.assertEqual(whole.count(b"\n"), 16 * 24)
        self.assertEqual(run("batch", *options, "--threads", 4).stdout, whole)
        out, partial = self.folder / "out", self.folder / "out.partial"
        rng = random.Random(6)
        for cut in (0, len(whole), *rng.sample(range(len(whole)), 8)):
            partial.write_bytes(whole[:cut])
            self.assertEqual(self.fine("batch", *options, "-o", out), "")
            self.assertEqual(out.read_bytes(), whole)
        partial.write_bytes(whole[:len(whole) // 2])
        self.fails(2, "--restart", "batch", *options, "--tight", "-o", out)
        (self.parts / "a.wkt").write_text(TRIANGLE)
        self.fails(2, "--restart", "batch", *options, "-o", out)

    def test_counts_without_output(self):
        stats = self.folder / "stats.json"
        self.assertEqual(self.fine("batch", "--pairs", self.parts, "--rotations", 4, "--no-output",
                                   "--stats", stats), "")
        found = json.loads(stats.read_text())
        self.assertEqual((found["jobs"], found["failed"], found["parts"]), (64, 0, 4))
        self.assertGreater(found["seconds"], 0)

    def test_failures(self):
        self.fails(2, "no parts", "batch", "--pairs", self.folder)
        self.fails(2, "cannot be read", "batch", "--pairs", self.folder / "nowhere")
        self.fails(1, "exclude", "batch", "--pairs", self.parts, "--no-output", "-o", "x")
        self.fails(1, "--tight needs", "batch", "--pairs", self.parts, "--operation", "sum",
                   "--tight")
        self.fails(1, "--rotations", "batch", "--pairs", self.parts, "--rotations", 0)
        result = run("batch", "--pairs", self.parts, "--max-segments", 3)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(result.stdout.count(b'"error":{"code":"limit"'), 16)
        self.assertEqual(result.stderr, b"minksum: 16 of 16 jobs failed\n")
        for name, text in (("e.wkt", "POINT (0 0)"), ("e.wkt", "POLYGON ((0 0"),
                           ("e.geojson", "{}")):
            (self.parts / name).write_text(text)
            self.fails(2, name, "batch", "--pairs", self.parts)
            (self.parts / name).unlink()


class BatchPage(Page, ProgramTest):
    page_name = "batch.md"


if __name__ == "__main__":
    main()
