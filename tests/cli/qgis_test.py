"""Tests the script of examples/qgis with a stub that has the names of QGIS's interface."""
import importlib.util
import os
import struct
import sys
import types
import unittest

from support import PROGRAM, SOURCE, main


class Anything:
    """Stands for classes of QGIS of which only names and arguments matter."""
    TypeVectorAnyGeometry = Unknown = FastInsert = 0

    def __init__(self, *arguments, **_):
        self.arguments = arguments


class QgsProcessingException(Exception):
    pass


class Geometry:
    def __init__(self, wkb=b"", wkt=None):
        self.wkb, self.wkt = wkb, wkt

    def asWkb(self):
        return bytearray(self.wkb)

    @staticmethod
    def fromWkt(text):
        return Geometry(wkt=text)


class Feature:
    def __init__(self, other=None, geometry=None):
        self.held = other.held if other else geometry

    def hasGeometry(self):
        return self.held is not None

    def geometry(self):
        return self.held

    def setGeometry(self, geometry):
        self.held = geometry


def polygon(*points, height=None):
    """Returns WKB of one ring, with a height if there is one."""
    code = 3 if height is None else 1003
    ring = [*points, points[0]]
    numbers = [n for x, y in ring for n in ((x, y) if height is None else (x, y, height))]
    return struct.pack(f"<BIII{len(numbers)}d", 1, code, 1, len(ring), *numbers)


class Layer:
    def __init__(self, features):
        self.features = features
        self.added = []

    def fields(self):
        return None

    sourceCrs = fields

    def featureCount(self):
        return len(self.features)

    def getFeatures(self):
        return iter(self.features)

    def addFeature(self, feature, _):
        self.added.append(feature)


class Feedback:
    def isCanceled(self):
        return False

    def setProgress(self, percent):
        self.percent = percent


def load_script():
    core = types.ModuleType("qgis.core")
    for name in ["QgsFeatureSink", "QgsProcessing", "QgsProcessingParameterEnum",
                 "QgsProcessingParameterFeatureSink", "QgsProcessingParameterFeatureSource",
                 "QgsProcessingParameterString", "QgsWkbTypes"]:
        setattr(core, name, type(name, (Anything,), {}))
    core.QgsFeature, core.QgsGeometry = Feature, Geometry
    core.QgsProcessingException = QgsProcessingException

    class QgsProcessingAlgorithm:
        def addParameter(self, parameter):
            self.__dict__.setdefault("declared", []).append(parameter.arguments[0])

        def parameterAsString(self, parameters, name, _):
            return parameters[name]

        parameterAsEnum = parameterAsSource = parameterAsString

        def parameterAsSink(self, parameters, name, *_):
            return parameters[name], name

    core.QgsProcessingAlgorithm = QgsProcessingAlgorithm
    sys.modules["qgis"], sys.modules["qgis.core"] = types.ModuleType("qgis"), core
    spec = importlib.util.spec_from_file_location("script",
                                                  SOURCE / "examples/qgis/minksum_sum.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    return script


class Script(unittest.TestCase):
    def setUp(self):
        self.script = load_script()
        self.algorithm = self.script.MinksumAlgorithm().createInstance()

    def run_on(self, features, **changed):
        target = Layer([])
        parameters = {"INPUT": Layer(features), "OUTPUT": target, "OPERATION": 0, "SIDE": 0,
                      "SHAPE": "box:2x2", "PROGRAM": os.path.abspath(PROGRAM), **changed}
        feedback = Feedback()
        self.assertEqual(self.algorithm.processAlgorithm(parameters, None, feedback),
                         {"OUTPUT": "OUTPUT"})
        self.assertEqual(feedback.percent, 100)
        return [feature.held and feature.held.wkt for feature in target.added]

    def test_parameters(self):
        self.algorithm.initAlgorithm()
        self.assertEqual(self.algorithm.declared,
                         ["INPUT", "OPERATION", "SHAPE", "SIDE", "PROGRAM", "OUTPUT"])
        for text in (self.algorithm.name(), self.algorithm.displayName(),
                     self.algorithm.shortHelpString()):
            self.assertTrue(text)

    def test_all_operations(self):
        square = ((0, 0), (4, 0), (4, 4), (0, 4))
        answers = ["POLYGON ((-1 -1, 5 -1, 5 5, -1 5, -1 -1))",
                   "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))",
                   "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"]
        self.assertEqual(len(answers), len(self.script.OPERATIONS))
        for operation, answer in enumerate(answers):
            for side in range(len(self.script.SIDES)):
                features = [Feature(geometry=Geometry(polygon(*square))), Feature(),
                            Feature(geometry=Geometry(polygon(*square, height=7)))]
                self.assertEqual(self.run_on(features, OPERATION=operation, SIDE=side),
                                 [answer, None, answer])

    def test_errors(self):
        feature = Feature(geometry=Geometry(polygon((0, 0), (1, 0), (0, 1))))
        with self.assertRaisesRegex(QgsProcessingException, "^minksum: "):
            self.run_on([feature], SHAPE="disc:wide")
        with self.assertRaisesRegex(QgsProcessingException, "not found"):
            self.run_on([feature], PROGRAM="no-such-program")


if __name__ == "__main__":
    main()
