"""Tests what becomes of NULL, of empty sets, of reference systems, and of bad input."""
from support import DatabaseTest, main

SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
EMPTY = "POLYGON EMPTY"


def geometry(text):
    return f"'{text}'::geometry"


def binary(function, a, b, *more):
    return f"SELECT mink_{function}({', '.join([geometry(a), geometry(b), *more])})"


class Input(DatabaseTest):
    def test_null_gives_null(self):
        functions = self.ask("""
            SELECT p.oid::regprocedure || '|' || proisstrict FROM pg_proc AS p
            JOIN pg_depend AS d ON d.objid = p.oid JOIN pg_extension AS x ON d.refobjid = x.oid
            WHERE x.extname LIKE 'minksum%' AND d.deptype = 'e' AND p.prokind = 'f'
              AND proname !~ '_(step|combine|finish|state)'""").splitlines()
        self.assertGreater(len(functions), 50)
        self.assertEqual([name for name in functions if not name.endswith("|true")], [])
        self.assertEqual(self.ask(f"SELECT mink_sum({geometry(SQUARE)}, NULL::geometry) IS NULL"),
                         "t")

    def test_all_are_immutable_and_parallel(self):
        self.assertEqual(self.ask("""
            SELECT count(*) FROM pg_proc AS p
            JOIN pg_depend AS d ON d.objid = p.oid JOIN pg_extension AS x ON d.refobjid = x.oid
            WHERE x.extname LIKE 'minksum%' AND d.deptype = 'e'
              AND (provolatile <> 'i' OR proparallel <> 's') AND prokind = 'f'"""), "0")

    def test_empty_sets(self):
        for function in ["sum", "no_fit_polygon"]:
            self.assertEqual(
                self.ask(binary(function, EMPTY, SQUARE).replace("SELECT", "SELECT ST_IsEmpty(") +
                         ")"), "t")
        self.assertEqual(
            self.ask(binary("sum", SQUARE, EMPTY).replace("SELECT", "SELECT ST_IsEmpty(") + ")"),
            "t")
        self.refused(binary("erode", SQUARE, EMPTY), "22023", "operand 2")
        self.assertEqual(self.ask("SELECT mink_sum_text('POINT EMPTY', 'POINT (1 1)')"),
                         self.ask("SELECT mink_resolve_text('POLYGON EMPTY')"))

    def test_reference_systems(self):
        system = f"SRID=4326;{SQUARE}"
        for a, b, srid in [(system, system, "4326"), (system, "POINT (1 1)", "4326"),
                           ("POINT (1 1)", system, "4326"), (SQUARE, SQUARE, "0")]:
            self.assertEqual(
                self.ask(binary("sum", a, b).replace("SELECT", "SELECT ST_SRID(") + ")"), srid)
        self.refused(binary("sum", system, f"SRID=3857;{SQUARE}"), "22023",
                     "two reference systems, 4326 and 3857", "ST_Transform")
        self.refused(f"SELECT mink_union_agg(g) FROM (VALUES ({geometry(system)}), "
                     f"('SRID=3857;POINT (1 1)')) AS s(g)", "22023", "two reference systems")
        self.assertEqual(self.ask(f"SELECT ST_SRID(mink_union_agg(g)) FROM (VALUES "
                                  f"({geometry(system)}), ('SRID=4326;POINT (9 1)')) AS s(g)"),
                         "4326")
        self.assertEqual(self.ask(f"SELECT mink_sum_text('{system}', 'POINT (1 1)')"),
                         "SRID=4326;POLYGON ((1 1, 5 1, 5 5, 1 5, 1 1))")

    def test_heights_and_measures(self):
        for text, name in [("POINT Z (1 2 3)", "POINT Z"), ("POINT M (1 2 3)", "POINT M"),
                           ("POINT ZM (1 2 3 4)", "POINT ZM"),
                           ("GEOMETRYCOLLECTION Z (POINT Z (1 2 3))", "GEOMETRYCOLLECTION Z")]:
            told = self.refused(binary("sum", SQUARE, text), "22023", name, "operand 2",
                                "HINT:  Drop heights and measures with ST_Force2D.")
            self.assertNotIn("io::", told)

    def test_curves_and_surfaces(self):
        for text in ["CIRCULARSTRING (0 0, 1 1, 2 0)", "CURVEPOLYGON ((0 0, 1 0, 1 1, 0 0))",
                     "GEOMETRYCOLLECTION (CIRCULARSTRING (0 0, 1 1, 2 0))"]:
            self.refused(binary("sum", text, SQUARE), "22023", "is not supported", "operand 1",
                         "ST_CurveToLine")
        self.refused(binary("sum", SQUARE, "TIN (((0 0, 1 0, 0 1, 0 0)))"), "22023", "TIN",
                     "Surfaces are not read")

    def test_words_and_numbers_that_are_empty(self):
        for call in [f"mink_resolve_text('{SQUARE}', '')", f"mink_resolve({geometry(SQUARE)}, '')",
                     f"mink_offset({geometry(SQUARE)}, 1, '')"]:
            self.refused(f"SELECT {call}", "22023", 'has no value ""')
        self.refused(f"SELECT mink_offset_text('{SQUARE}', '')", "22P02", "distance is not a number")

    def test_answers_beyond_the_doubles(self):
        ends = "'POINT(-1.5e308 0)'::geometry, 'POINT(1.5e308 0)'::geometry"
        self.refused(f"SELECT mink_depth({ends})", "54000", "beyond the range of doubles")
        self.refused(f"SELECT mink_impact({ends}, -1e-300, 0)", "54000", "range of doubles")

    def test_numbers_that_are_not_finite(self):
        self.refused("SELECT mink_sum(ST_MakePoint('inf', 0), ST_MakePoint(1, 1))", "22023",
                     "not a finite number")
        self.refused(f"SELECT mink_offset({geometry(SQUARE)}, 'nan')", "22023")

    def test_broken_bytes(self):
        whole = self.ask(f"SELECT encode(ST_AsBinary({geometry(SQUARE)}), 'hex')")
        for length in range(0, len(whole), 2):
            self.refused(f"SELECT mink_resolve('\\x{whole[:length]}'::bytea)", "22P03", "operand 1")
        # Counts beyond the end do not reserve memory.
        self.refused("SELECT mink_resolve('\\x0103000000ffffffff'::bytea)", "22P03")
        for code in ("0112000000", "0163000000", "0100000000"):
            self.refused(f"SELECT mink_resolve('\\x{code}00000000'::bytea)", "22P03", "bytes 2 to 5")
        self.refused("SELECT mink_resolve('{}'::bytea)", "22P03", "ST_AsEWKB")

    def test_broken_text(self):
        self.refused("SELECT mink_resolve_text('POLYGON ((0 0, 4 4, 4 O, 0 0))')", "22P02",
                     "expected a number, found 'O'", "operand 1, line 1, column 23")
        self.refused("SELECT mink_resolve_text('{\"type\": \"Point\"}')", "22P02", "expected WKT")
        self.refused(f"SELECT mink_offset_text('{SQUARE}', 'wide')", "22P02", "distance")

    def test_rings_that_are_not_valid(self):
        bow = "MULTIPOLYGON (((9 9, 10 9, 10 10, 9 9)), ((0 0, 4 4, 4 0, 0 4, 0 0)))"
        self.assertEqual(self.ask(binary("sum", bow, "POINT (0 0)").replace(
            "SELECT", "SELECT ST_IsValid(") + ")"), "t")
        self.refused(binary("sum", SQUARE, bow, "'strict'"), "22023", "edges cross at (2, 2)",
                     "operand 2, polygon 2, ring 1, vertex 1")
        # An operand that came before is not taken for a valid one.
        self.refused(f"SELECT mink_sum(g, {geometry(SQUARE)}, 'strict') FROM (VALUES "
                     f"({geometry(SQUARE)}), ({geometry(SQUARE)}), ({geometry(bow)})) AS s(g)",
                     "22023", "operand 1, polygon 2, ring 1, vertex 1")

    def test_words(self):
        self.refused(binary("sum", SQUARE, SQUARE, "'odd'"), "22023", 'fill has no value "odd"',
                     "Choose one of: automatic, evenodd, nonzero")
        self.refused(binary("sum", SQUARE, SQUARE, "round => 'up'"), "22023", "nearest, outside")
        self.refused(f"SELECT mink_offset({geometry(SQUARE)}, 1, 'flat')", "22023", "join_style")
        self.refused(f"SELECT mink_offset({geometry(SQUARE)}, 1, tolerance => -1)", "22023")

    def test_limits(self):
        self.refused("SET minksum.max_segments = 10; " + f"""
            SELECT mink_sum(ST_Buffer('POINT (0 0)'::geometry, 3), ST_Difference(
            ST_Buffer('POINT (0 0)'::geometry, 9), ST_Buffer('POINT (0 0)'::geometry, 8)))""",
                     "54000", "Raise minksum.max_segments")
        # The first call loads the module, which knows its settings.
        loaded = "SELECT mink_resolve_text('POINT (1 1)'); "
        self.refused(loaded + "SET minksum.max_segments = 0", "22023")
        self.refused(loaded + "SET minksum.no_such_setting = 1", "42602")


if __name__ == "__main__":
    main()
