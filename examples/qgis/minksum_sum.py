"""A script for QGIS's Processing toolbox: the Minkowski sum of each feature with a shape.

Copy this file into QGIS by Processing > Toolbox > Python > Add Script to Toolbox. It calls the
program `minksum`, which must be on the PATH or be named by the parameter. Nothing else is needed.
"""
import shutil
import subprocess

from qgis.core import (QgsFeature, QgsFeatureSink, QgsGeometry, QgsProcessing,
                       QgsProcessingAlgorithm, QgsProcessingException,
                       QgsProcessingParameterEnum, QgsProcessingParameterFeatureSink,
                       QgsProcessingParameterFeatureSource, QgsProcessingParameterString,
                       QgsWkbTypes)

OPERATIONS = ["sum", "erode", "open", "close"]
SIDES = ["nearest", "outside", "inside"]


def command(program, operation, shape, side):
    """Returns the command line that reads one feature from standard input."""
    return [program, operation, "-", shape, "--round", side, "--drop-z", "-q"]


def compute(arguments, wkb):
    """Returns as WKT what the program makes of one geometry, or raises an error with its message."""
    done = subprocess.run(arguments, input=wkb, capture_output=True, check=False)
    if done.returncode:
        raise QgsProcessingException(done.stderr.decode().strip())
    return done.stdout.decode().strip()


class MinksumAlgorithm(QgsProcessingAlgorithm):
    """Grows, shrinks, opens or closes each feature by a shape."""

    def createInstance(self):
        return MinksumAlgorithm()

    def name(self):
        return "minksum"

    def displayName(self):
        return "Minkowski sum and morphology (exact)"

    def shortHelpString(self):
        return ("Computes the Minkowski sum, erosion, opening or closing of each feature by a shape. "
                "The shape is WKT, or disc:R, box:WxH or ngon:N:R in the layer's unit. "
                "Heights and measures are dropped.")

    def initAlgorithm(self, config=None):
        self.addParameter(QgsProcessingParameterFeatureSource(
            "INPUT", "Layer", [QgsProcessing.TypeVectorAnyGeometry]))
        self.addParameter(QgsProcessingParameterEnum("OPERATION", "Operation", OPERATIONS,
                                                     defaultValue=0))
        self.addParameter(QgsProcessingParameterString("SHAPE", "Shape", "disc:10"))
        self.addParameter(QgsProcessingParameterEnum("SIDE", "Round to", SIDES, defaultValue=0))
        self.addParameter(QgsProcessingParameterString("PROGRAM", "Program", "minksum"))
        self.addParameter(QgsProcessingParameterFeatureSink("OUTPUT", "Result"))

    def processAlgorithm(self, parameters, context, feedback):
        program = shutil.which(self.parameterAsString(parameters, "PROGRAM", context))
        if program is None:
            raise QgsProcessingException("The program minksum was not found: name it by its path.")
        arguments = command(program, OPERATIONS[self.parameterAsEnum(parameters, "OPERATION",
                                                                     context)],
                            self.parameterAsString(parameters, "SHAPE", context),
                            SIDES[self.parameterAsEnum(parameters, "SIDE", context)])
        source = self.parameterAsSource(parameters, "INPUT", context)
        sink, target = self.parameterAsSink(parameters, "OUTPUT", context, source.fields(),
                                            QgsWkbTypes.Unknown, source.sourceCrs())
        count = source.featureCount() or 1
        for done, feature in enumerate(source.getFeatures()):
            if feedback.isCanceled():
                break
            result = QgsFeature(feature)
            if feature.hasGeometry():
                answer = compute(arguments, bytes(feature.geometry().asWkb()))
                result.setGeometry(QgsGeometry.fromWkt(answer))
            sink.addFeature(result, QgsFeatureSink.FastInsert)
            feedback.setProgress(100 * (done + 1) / count)
        return {"OUTPUT": target}
