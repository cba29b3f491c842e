"""Tests how the extensions live in the server: memory, workers, interrupts, updates and crashes."""
import os
import signal
import subprocess
import time
import unittest

from support import OPTIONS, DatabaseTest, main, psql

# A sum of two of these takes far longer than any test: thousands of small discs. The server computes
# one disc when it plans the query. So a timeout does not meet PostGIS, which would tell it as a
# user's request.
SLOW = ("(SELECT ST_Collect(ST_Translate(ST_Buffer('POINT (0 0)'::geometry, 0.9, 20), x * 1.7, "
        "(x * x) % 97)) AS g FROM generate_series(1, 4000) AS x) AS s")


class Memory(DatabaseTest):
    def test_many_calls_without_growth(self):
        """After 10^5 calls of each function, 10^5 more take no more memory."""
        calls = """
            SELECT count(mink_sum(ST_MakeEnvelope(x, 0, x + 1, 1), ST_MakeEnvelope(0, 0, 1, 1))),
              count(mink_offset(ST_MakePoint(x, 1), 1, tolerance => 0.1)),
              count(mink_erode(ST_MakeEnvelope(x, 0, x + 1, 1), ST_MakeEnvelope(0, 0, 0.5, 0.5)))
            FROM generate_series(1, {}) AS x;
            SELECT (regexp_match(pg_read_file('/proc/' || pg_backend_pid() || '/status', 0, 4000),
               'VmRSS:\\s+(\\d+) kB'))[1];"""
        lines = self.ask(calls.format(100000) * 2).split("\n")
        self.assertEqual(lines[2], "100000|100000|100000")
        self.assertLess(int(lines[3]) - int(lines[1]), 4 << 10)

    def test_many_states_without_growth(self):
        """Each group of an aggregate has a state, and so has each set of rows."""
        groups = """
            SELECT count(*) FROM (SELECT mink_union_agg(ST_MakeEnvelope(x, 0, x + 1, 1))
              FROM generate_series(1, {}) AS x GROUP BY x % 100) AS s;
            SELECT count(*) FROM generate_series(1, {} / 10) AS x, LATERAL mink_slices(
              ST_MakeEnvelope(x, 0, x + 1, 1), ST_MakeEnvelope(0, 0, 1, 1), 2);
            SELECT (regexp_match(pg_read_file('/proc/' || pg_backend_pid() || '/status', 0, 4000),
               'VmRSS:\\s+(\\d+) kB'))[1];"""
        lines = self.ask(groups.format(5000, 5000) * 2).split("\n")
        self.assertEqual(lines[4], "1000")
        self.assertLess(int(lines[5]) - int(lines[2]), 4 << 10)


class Plans(DatabaseTest):
    PARALLEL = ("SET max_parallel_workers_per_gather = {}; SET parallel_setup_cost = 0; "
                "SET parallel_tuple_cost = 0; SET min_parallel_table_scan_size = 0; ")

    def test_inlined(self):
        """A query sees the function on bytea, and a constant is converted once."""
        plan = self.ask("EXPLAIN (VERBOSE, COSTS OFF) SELECT mink_sum(ST_MakePoint(x, x), "
                        "'POINT (1 1)'::geometry) FROM generate_series(1, 3) AS x")
        self.assertIn("::bytea, '\\x01010000", plan)

    def test_two_workers(self):
        self.ask("""CREATE TABLE shapes AS SELECT x AS id, ST_MakeEnvelope(x, 0, x + 3, 1 + x % 7)
              AS g FROM generate_series(1, 3000) AS x;
            ALTER TABLE shapes SET (parallel_workers = 2); ANALYZE shapes;""")
        queries = [
            "SELECT count(*) FROM shapes WHERE ST_Area(mink_open(g, mink_disc(1, 0.1)::geometry)) "
            "> 5",
            "SELECT md5(ST_AsBinary(mink_union_agg(g))) FROM shapes",
            "SELECT md5(ST_AsBinary(mink_sum_agg(g))) FROM shapes",
            "SELECT md5(mink_union_agg_text(ST_AsText(g))) FROM shapes",
        ]
        for query in queries:
            with self.subTest(query=query):
                plan = self.ask(self.PARALLEL.format(2) + "EXPLAIN (ANALYZE, COSTS OFF, TIMING OFF) "
                                + query)
                self.assertIn("Workers Launched: 2", plan)
                alone = self.ask(self.PARALLEL.format(0) + query)
                self.assertEqual(self.ask(self.PARALLEL.format(2) + query), alone)
                self.assertNotIn(alone, ["", "0"])

    def test_operand_that_comes_again(self):
        """A prepared operand gives the sums that one without preparation gives."""
        self.assertEqual(self.ask("""
            WITH given AS (SELECT x, ST_MakeEnvelope(x, 0, x + 2, x % 5) AS a,
                ST_Buffer('POINT (0 0)'::geometry, 1, 2) AS b FROM generate_series(0, 40) AS x)
            SELECT count(*), bool_and(s.together = s.alone) FROM (
              SELECT mink_sum(a, b)::bytea AS together,
                (SELECT mink_sum(g.a, g.b)::bytea FROM given AS g WHERE g.x = given.x) AS alone
              FROM given) AS s"""), "41|t")


    def test_an_operand_is_prepared_once(self):
        """A query prepares an operand when it comes again, and a new one only then."""
        count = "SHOW minksum.prepared_operands;"
        query = ("SELECT count(mink_sum(ST_MakeEnvelope(x, 0, x + 2, 1), ST_Buffer(ST_MakePoint("
                 "{}, 0), 1))) FROM generate_series(1, 50) AS x;")
        load = "SELECT mink_sum_text('POINT (0 0)', 'POINT (0 0)');"
        rows = self.ask(load + count + query.format(0) + count + query.format(0) + count
                        + query.format("x / 10") + count + query.format("x") + count)
        # x / 10 goes from 0 to 5, and 5 comes once.
        self.assertEqual(rows.split("\n")[1:],
                         ["0", "50", "1", "50", "2", "50", "7", "50", "7"])
        self.refused(load + "SET minksum.prepared_operands = 1", "55P02")


class Interrupts(DatabaseTest):
    SLOW_QUERIES = [
        f"SELECT length(mink_sum(g, g)::bytea) FROM {SLOW}",
        f"SELECT length(mink_offset(g, -1e-3, tolerance => 1e-9)::bytea) FROM {SLOW}",
        f"SELECT length(mink_sum_text(t, t)) FROM (SELECT ST_AsText(g) AS t FROM {SLOW}) AS u",
        f"SELECT count(*) FROM (SELECT g FROM {SLOW}) AS u, mink_slices(u.g, u.g, 100, true)",
        "SELECT length(mink_sum_agg(g)::bytea) FROM (SELECT ST_Translate(ST_Buffer("
        "'POINT (0 0)'::geometry, 9, 500), x, x * x) AS g FROM generate_series(1, 100000) AS x) "
        "AS s",
    ]

    def test_statement_timeout(self):
        for query in self.SLOW_QUERIES:
            with self.subTest(query=query[:40]):
                self.refused(f"SET statement_timeout = 1000; {query}", "57014",
                             "statement timeout")

    def test_cancel(self):
        """The server ends a sum that another session cancels, and the session goes on."""
        with subprocess.Popen(["psql", *OPTIONS[:4], self.database], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as session:
            session.stdin.write(f"{self.SLOW_QUERIES[0]};\nSELECT 'alive';\n")
            session.stdin.flush()
            backend = self.running("mink_sum(g, g)")
            # Let it get into the library.
            time.sleep(0.5)
            self.assertEqual(self.ask(f"SELECT pg_cancel_backend({backend})"), "t")
            out, told = session.communicate(timeout=60)
        self.assertIn("canceling statement due to user request", told)
        self.assertEqual(out.strip(), "alive")

    def running(self, fragment):
        """Waits until a query with this fragment runs, and returns its process."""
        for _ in range(300):
            found = self.ask(f"SELECT pid FROM pg_stat_activity WHERE state = 'active' AND query "
                             f"LIKE '%{fragment}%' AND pid <> pg_backend_pid()")
            if found:
                return int(found)
            time.sleep(0.1)
        raise AssertionError("the query did not begin")


class Update(DatabaseTest):
    extensions = ["postgis"]

    def test_from_the_version_before(self):
        listed = """SELECT string_agg(name, ',' ORDER BY name) FROM (SELECT concat(
              p.oid::regprocedure, provolatile, proparallel, procost) AS name FROM pg_proc AS p
            JOIN pg_depend AS d ON d.objid = p.oid JOIN pg_extension AS x ON d.refobjid = x.oid
            WHERE extname = 'minksum' AND d.deptype = 'e') AS s;"""
        rows = self.ask(f"""
            CREATE EXTENSION minksum VERSION '0.0.9';
            SELECT count(*) FROM pg_proc WHERE proname IN ('mink_union_agg', 'mink_is_sum');
            CREATE VIEW used AS SELECT mink_sum_text('POINT (1 1)', 'POINT (2 3)') AS made;
            ALTER EXTENSION minksum UPDATE TO '0.1.0';
            SELECT made FROM used;
            SELECT mink_union_agg_text(made) FROM used;
            SELECT extversion FROM pg_extension WHERE extname = 'minksum';
            {listed}""").splitlines()
        self.assertEqual(rows[:4], ["0", "POINT (3 4)", "POINT (3 4)", "0.1.0"])
        fresh = self.ask(f"""DROP EXTENSION minksum CASCADE; CREATE EXTENSION minksum; {listed}
            CREATE EXTENSION minksum_postgis; DROP EXTENSION minksum CASCADE;
            SELECT count(*) FROM pg_proc WHERE proname LIKE 'mink\\_%';""").splitlines()
        self.assertEqual(fresh, [rows[4], "0"])


@unittest.skipUnless(os.path.isdir("/proc/self"), "there is no /proc")
class Crash(Interrupts):
    """A process that is killed in the middle of a sum takes nothing with it."""
    test_statement_timeout = None
    test_cancel = None

    def test_killed_process(self):
        self.ask("CREATE TABLE kept AS SELECT 1 AS one")
        query = (f"BEGIN; INSERT INTO kept VALUES (2); {self.SLOW_QUERIES[0]}; COMMIT;")
        with subprocess.Popen(["psql", *OPTIONS, self.database], stdin=subprocess.PIPE,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True) as session:
            session.stdin.write(query)
            session.stdin.close()
            backend = self.running("mink_sum(g, g)")
            time.sleep(0.5)
            os.kill(backend, signal.SIGKILL)
            session.wait(timeout=60)
        self.assertNotEqual(session.returncode, 0)
        for _ in range(300):  # the server starts its other processes anew
            if psql(self.database, "SELECT 1").returncode == 0:
                break
            time.sleep(0.1)
        self.assertEqual(self.ask("SELECT count(*) FROM kept; SELECT count(*) FROM "
                                  "pg_stat_activity WHERE state = 'active'"), "1\n1")
        self.assertEqual(self.ask("SELECT mink_sum_text('POINT (1 1)', 'POINT (2 3)')"),
                         "POINT (3 4)")


if __name__ == "__main__":
    main()
