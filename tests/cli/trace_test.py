"""Tests minksum sum --trace: pictures and data of every stage."""
import json
import os
import xml.etree.ElementTree

from support import ProgramTest, main

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "..", "examples")
STAGES = ["1-operands", "2-convolution", "3-cover", "4-arrangement", "5-loops", "6-rejected",
          "7-result"]


class Trace(ProgramTest):
    def trace(self, *extra):
        folder = self.folder / "trace"
        self.fine("sum", os.path.join(EXAMPLES, "star.wkt"),
                  os.path.join(EXAMPLES, "star_turned.wkt"), "-o", self.folder / "sum.wkt",
                  "--stats", self.folder / "stats.json", "--trace", folder, *extra)
        for name in STAGES:
            xml.etree.ElementTree.parse(folder / f"{name}.svg")
        data = {}
        for name in STAGES:
            path = folder / (f"{name}.json" if name == "3-cover" else f"{name}.geojson")
            data[name] = json.loads(path.read_text())
        self.assertEqual(len(list(folder.iterdir())), 2 * len(STAGES))
        return data, json.loads((self.folder / "stats.json").read_text())

    def test_counts_agree_with_the_statistics(self):
        for extra in ([], ["--no-cover"], ["--grid", "16"]):
            with self.subTest(str(extra)):
                data, stats = self.trace(*extra)
                counts = stats["counts"]
                segments = data["2-convolution"]["features"]
                self.assertEqual(len(segments), counts["convolution_segments"])
                self.assertEqual(sum(s["properties"]["kept"] for s in segments),
                                 counts["segments_kept"])
                cover = data["3-cover"]
                self.assertEqual(cover["columns"] * cover["rows"], counts["grid_cells"])
                self.assertEqual(sum(row.count("1") for row in cover["covered"]),
                                 counts["covered_cells"])
                states = [f["properties"]["state"] for f in data["5-loops"]["features"]]
                self.assertEqual(len(states), counts["loops"])
                self.assertEqual(states.count("rejected by nesting"), counts["rejected_by_nesting"])
                self.assertEqual(states.count("rejected by collision"),
                                 counts["rejected_by_collision"])
                rejected = counts["rejected_by_nesting"] + counts["rejected_by_collision"]
                self.assertEqual(len(data["6-rejected"]["features"]), rejected)

    def test_result(self):
        data, stats = self.trace()
        rings = data["7-result"]["coordinates"]
        self.assertEqual(sum(len(ring) - 1 for ring in rings), stats["result"]["vertices"])
        self.assertEqual(len(data["1-operands"]["features"]), 2)


if __name__ == "__main__":
    main()
