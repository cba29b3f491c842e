"""Tests that each function gives the program's answer, as geometry and as exact text."""
import hashlib
import re

from support import EXAMPLES, DatabaseTest, main, program

P = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))"
Q = "POLYGON ((0 0, 0.1 0, 0.3 0.7, 0 0))"
BOW = "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))"
DISC = "POLYGON ((1 0, 0 1, -1 0, 0 -1, 1 0))"
# The functions of two sets and the commands that compute the same.
COMMANDS = {"sum": "sum", "erode": "erode", "open": "open", "close": "close",
            "no_fit_polygon": "nfp", "inner_fit_polygon": "ifp"}


def example(name):
    return (EXAMPLES / f"{name}.wkt").read_text().strip()


def geometry(text):
    return f"'{text}'::geometry"


class Functions(DatabaseTest):
    def assert_same(self, query, *command):
        """Compares a geometry with the program's answer, byte by byte.

        The program gets operands as WKB, because it reads decimals in WKT exactly.
        """
        answer = program(*[self.as_file(text) if "(" in str(text) else text for text in command])
        self.assertEqual(
            self.ask(f"SELECT ST_AsBinary(a) = ST_AsBinary(b), CASE WHEN a::bytea <> b::bytea THEN "
                     f"ST_AsText(a) END FROM (SELECT {query} AS a, {geometry(answer)} AS b) AS s"),
            "t|")

    def as_file(self, text):
        """Returns the name of a file that holds the operand as doubles."""
        name = f"{hashlib.md5(text.encode()).hexdigest()}.wkb"
        with open(name, "w", encoding="ascii") as file:
            file.write(self.ask(f"SELECT encode(ST_AsBinary({geometry(text)}), 'hex')"))
        return name

    def test_pairs(self):
        pairs = [(P, Q), (BOW, DISC), (P, DISC), (example("bracket"), example("peg")),
                 (example("coral"), example("disc32")), (example("plate"), example("tile"))]
        for a, b in pairs:
            for function, command in COMMANDS.items():
                with self.subTest(function=function, a=a[:40], b=b[:40]):
                    self.assert_same(f"mink_{function}({geometry(a)}, {geometry(b)})", command, a,
                                     b)
                    exact = program(command, a, b, "--coords", "exact")
                    self.assertEqual(self.ask(f"SELECT mink_{function}_text('{a}', '{b}')"), exact)

    def test_thin_sets(self):
        line, point = "LINESTRING (0 0, 5 0, 5 5)", "MULTIPOINT ((1 1), (2 3))"
        for a, b in [(line, DISC), (line, point), (point, point), (P, line)]:
            self.assert_same(f"mink_sum({geometry(a)}, {geometry(b)})", "sum", a, b)

    def test_fill(self):
        for fill in ["automatic", "evenodd", "nonzero", "positive", "negative"]:
            self.assert_same(f"mink_sum({geometry(BOW)}, {geometry(Q)}, '{fill}')", "sum", BOW, Q,
                             "--fill", fill)

    def test_round(self):
        thirds = "POLYGON ((0 0, 3 1, 1 3, 0 0), (1 1, 1.5 1, 1 1.5, 1 1))"
        sides = set()
        for side in ["nearest", "outside", "inside"]:
            query = f"mink_open({geometry(thirds)}, {geometry(Q)}, round => '{side}')"
            self.assert_same(query, "open", thirds, Q, "--round", side)
            sides.add(self.ask(f"SELECT {query}"))
        self.assertEqual(len(sides), 3)

    def test_offset(self):
        for distance in ["1", "-0.5"]:
            self.assert_same(f"mink_offset({geometry(P)}, {distance})", "offset", P,
                             "--distance", distance)
        self.assert_same(f"mink_offset({geometry(P)}, 2, join_style => 'miter', miter_limit => 3)",
                         "offset", P, "--distance", 2, "--join", "miter", "--miter-limit", 3)
        self.assert_same(f"mink_offset({geometry('LINESTRING (0 0, 5 1)')}, 2, tolerance => 0.125,"
                         " side => 'outside', round => 'outside')", "offset",
                         "LINESTRING (0 0, 5 1)", "-d", 2, "--tolerance", 0.125, "--side", "outside")
        self.assertEqual(self.ask(f"SELECT mink_offset_text('{P}', '1/3')"),
                         program("offset", P, "--distance", "1/3", "--coords", "exact"))

    def test_resolve(self):
        self.assertEqual(self.ask(f"SELECT mink_resolve_text('{BOW}')"),
                         "MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))")
        self.assertEqual(self.ask(f"SELECT ST_AsText(mink_resolve({geometry(BOW)}))"),
                         "MULTIPOLYGON(((0 0,2 2,0 4,0 0)),((2 2,4 0,4 4,2 2)))")

    def test_booleans(self):
        other = "POLYGON ((-1 -1, 4 -1, 4 4, -1 4, -1 -1))"
        for name, peer in [("union", "ST_Union"), ("intersection", "ST_Intersection"),
                           ("difference", "ST_Difference"),
                           ("sym_difference", "ST_SymDifference")]:
            a, b = geometry(P), geometry(other)
            self.assertEqual(self.ask(f"SELECT ST_Equals(mink_{name}({a}, {b}), {peer}({a}, {b}))"
                                      f", ST_Equals(mink_{name}_text('{P}', '{other}')::geometry, "
                                      f"{peer}({a}, {b}))"), "t|t")

    def test_disc(self):
        self.assertEqual(
            self.ask("SELECT ST_AsText(mink_disc(2, 0.5)::geometry)").replace(",", ", "),
            program("sum", "POINT (0 0)", "disc:2", "--tolerance", "0.5").replace("POLYGON (",
                                                                                 "POLYGON("))

    def test_reference(self):
        at = geometry("POINT (1 1)")
        self.assertEqual(
            self.ask(f"SELECT ST_AsText(mink_no_fit_polygon({geometry(DISC)}, {geometry(DISC)}, "
                     f"{at})), ST_AsText(mink_inner_fit_polygon({geometry(DISC)}, "
                     f"{geometry(DISC)}, {at}))"),
            "POLYGON((-1 1,1 -1,3 1,1 3,-1 1))|POINT(1 1)")
        self.refused(f"SELECT mink_no_fit_polygon({geometry(DISC)}, {geometry(DISC)}, "
                     f"{geometry(DISC)})", "22023", "the reference must be one point")

    def test_depth(self):
        a, b = "POLYGON ((0 0, 4 0, 0 4, 0 0))", "POLYGON ((1 1, 4 1, 1 4, 1 1))"
        told = program("depth", a, b)
        for call in [f"mink_depth({geometry(a)}, {geometry(b)})", f"mink_depth_text('{a}', '{b}')"]:
            row = self.ask(f"SELECT overlapping, distance, dx, dy, squared FROM {call}")
            self.assertEqual(row, "t|1.4142135623730951|1|1|2")
            self.assertIn("1.4142135623730951", told)
        self.assertEqual(self.ask(f"SELECT overlapping, squared FROM mink_depth({geometry(a)}, "
                                  "'POINT (1 1)'::geometry)"), "t|1")
        self.assertEqual(self.ask(f"SELECT mink_depth({geometry(a)}, 'POINT EMPTY'::geometry) "
                                  "IS NULL"), "t")

    def test_impact(self):
        a, b = "POLYGON ((5 0, 7 0, 7 2, 5 2, 5 0))", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
        self.assertEqual(self.ask(f"SELECT mink_impact({geometry(a)}, {geometry(b)}, 2, 0), "
                                  f"mink_impact_text('{a}', '{b}', 0, 1) IS NULL"), "2|t")

    def test_is_sum(self):
        total = program("sum", P, Q, "--coords", "exact")
        self.assertEqual(
            self.ask(f"SELECT mink_is_sum_text('{total}', '{P}', '{Q}'), "
                     f"mink_is_sum_text('{P}', '{P}', '{Q}'), "
                     f"mink_is_sum(mink_sum({geometry(P)}, {geometry(Q)}), {geometry(P)}, "
                     f"{geometry(Q)}, 1e-9)"), "t|f|t")

    def test_slices(self):
        rows = self.ask(f"SELECT slice, degrees, ST_AsText(blocked), ST_AsText(free) FROM "
                        f"mink_slices({geometry(DISC)}, {geometry(P)}, 4, true)").splitlines()
        self.assertEqual(len(rows), 4)
        self.assertEqual([row.split("|")[:2] for row in rows],
                         [["0", "0"], ["1", "90"], ["2", "180"], ["3", "270"]])
        blocked = self.ask(f"SELECT ST_AsText(mink_sum({geometry(P)}, {geometry(DISC)}))")
        for row in rows:
            self.assertEqual(row.split("|")[2], blocked)
            self.assertNotEqual(row.split("|")[3], "")
        self.assertEqual(self.ask(f"SELECT count(*), count(free) FROM mink_slices({geometry(DISC)}"
                                  f", {geometry(P)}, 5)"), "5|0")
        # None is made before it is asked for.
        self.assertEqual(self.ask(f"SELECT (mink_slices({geometry(DISC)}::bytea, {geometry(P)}::bytea, "
                                  "2000000000)).degrees LIMIT 1"), "0")
        self.refused(f"SELECT * FROM mink_slices({geometry(DISC)}, {geometry(P)}, 0)", "22023",
                     "angles must be positive")

    def test_no_fit_table(self):
        parts = f"ARRAY[{geometry(DISC)}, {geometry(P)}, {geometry(Q)}]"
        self.assertEqual(self.ask(f"SELECT count(*), count(DISTINCT (fixed, fixed_turn, moving, "
                                  f"moving_turn)) FROM mink_no_fit_table({parts}, 4)"), "144|144")
        # Each polygon is that of the parts as placed, with the fixed part's first vertex at 0.
        wrong = self.ask(f"""
            WITH parts AS (SELECT ordinality AS i, g,
                ST_Translate(g, -ST_X(ST_PointN(ST_ExteriorRing(g), 1)),
                                -ST_Y(ST_PointN(ST_ExteriorRing(g), 1))) AS laid
              FROM unnest({parts}) WITH ORDINALITY AS u(g, ordinality))
            SELECT count(*), bool_and(ST_Equals(t.polygon, mink_no_fit_polygon(
                ST_Rotate(a.laid, pi() / 2 * fixed_turn), ST_Rotate(b.laid, pi() / 2 * moving_turn),
                'POINT (0 0)'::geometry)))
            FROM mink_no_fit_table({parts}, 1) AS t, parts a, parts b
            WHERE a.i = t.fixed AND b.i = t.moving""")
        self.assertEqual(wrong, "9|t")
        self.refused(f"SELECT * FROM mink_no_fit_table(ARRAY[{geometry(DISC)}, NULL], 1)", "22004",
                     "part 2 is NULL")
        self.refused(f"SELECT * FROM mink_no_fit_table({parts}, 3)", "22023")
        self.refused(f"SELECT * FROM mink_no_fit_table(ARRAY[{geometry(P)}, "
                     f"{geometry('POINT (1 1)')}], 1)", "22023", "operand 2")

    def test_aggregates(self):
        boxes = ("(SELECT ST_MakeEnvelope(x, 0, x + 2, 1 + x) AS g FROM generate_series(1, 3) AS "
                 "x UNION ALL SELECT NULL) AS s")
        self.assertEqual(
            self.ask(f"SELECT ST_Equals(mink_union_agg(g), ST_Union(g)) FROM {boxes}"), "t")
        self.assertEqual(self.ask(f"SELECT ST_AsText(mink_sum_agg(g)) FROM {boxes}"),
                         "POLYGON((6 0,12 0,12 9,6 9,6 0))")
        self.assertEqual(
            self.ask(f"SELECT mink_sum_agg_text(ST_AsText(g)) FROM {boxes}"),
            "POLYGON ((6 0, 12 0, 12 9, 6 9, 6 0))")
        self.assertEqual(
            self.ask(f"SELECT mink_union_agg_text(ST_AsText(g)) FROM {boxes}"),
            "POLYGON ((1 0, 5 0, 5 4, 3 4, 3 3, 2 3, 2 2, 1 2, 1 0))")
        self.assertEqual(
            self.ask(f"SELECT mink_union_agg(g) IS NULL FROM {boxes} WHERE false"), "t")

    def test_every_function_is_called(self):
        """A function that this file does not call fails the test."""
        names = self.ask("""SELECT DISTINCT proname FROM pg_proc JOIN pg_depend ON objid = pg_proc.oid
            JOIN pg_extension x ON refobjid = x.oid
            WHERE x.extname LIKE 'minksum%' AND deptype = 'e' ORDER BY 1""").split()
        with open(__file__, encoding="utf-8") as file:
            called = file.read()
        inner = re.compile(r"_(step|combine|finish|state)(_text|_geometry)?$")
        families = {f"mink_{name}{end}" for name in [*COMMANDS, "union", "intersection",
                                                     "difference", "sym_difference"]
                    for end in ("", "_text")}
        self.assertGreater(len(names), 40)
        self.assertEqual([name for name in names if not inner.search(name)
                          and name not in families and f"{name}(" not in called], [])


if __name__ == "__main__":
    main()
