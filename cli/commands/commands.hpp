// Declares exit codes, and the subcommands that have no header of their own, with their arguments.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "minksum/cancel.hpp"
#include "minksum/check.hpp"
#include "minksum/depth.hpp"
#include "minksum/io.hpp"
#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/offset.hpp"
#include "minksum/round.hpp"
#include "minksum/testing.hpp"
#include "minksum/transform.hpp"

namespace minksum::cli {

/// Exit codes of the program; `docs/cli.md` and `--help` list the same.
enum ExitCode : int {
  kFine = 0,
  kWrongUsage = 1,
  kBadInput = 2,       ///< also: an output that cannot be written
  kLimitExceeded = 3,  ///< a stated limit, or memory
  kInternal = 4,
  kWrongResult = 5,  ///< `minksum check` found an error
};

/// Says where and how a result is written. `convert_result` sets what follows from the three texts.
struct ResultArguments {
  std::string output;  ///< empty = standard output
  std::string typed_format;
  std::string typed_coordinates = "double";
  std::string typed_rounding;
  io::Format format = io::Format::kWkt;
  bool lines = false;  ///< GeoJSON: a text a line
  io::Coordinates coordinates;
  RoundingSide rounding = RoundingSide::kNearest;  ///< unused for exact coordinates
  std::optional<CancelToken> cancel;               ///< stops rounding and, in jobs, writing
  std::function<bool(const Progress&)> progress;   ///< is told of rounding
};

/// Asks for the operation on each feature of the first operand.
struct EachArguments {
  bool each = false;
  bool restart = false;  ///< forgets what an earlier run has left
  std::string settings;  ///< the options that results depend on, as they were typed
};

/// `minksum sum P Q ...`
struct SumArguments : ResultArguments, EachArguments {
  std::string operands[2];       ///< file names; "-" = standard input
  bool keep_properties = false;  ///< write a Feature with P's properties
  std::string tight;             ///< empty = none
  io::Format tight_format = io::Format::kWkt;
  std::string stats;    ///< empty = none
  std::string picture;  ///< empty = none
  std::string trace;    ///< a folder; empty = none
  int repeat = 1;
  bool verbose = false;
  io::ReadOptions limits;
  SumSettings options;
};

/// `minksum info FILE...`
struct InfoArguments {
  std::vector<std::string> files;
  bool json = false;
  bool exact = false;  ///< fractions, not only decimals
  std::uint64_t max_crossings = 0;
  io::ReadOptions limits;
  Options options;
};
/// No geometry is written, and no option depends on another one.
inline void convert(const InfoArguments&) {}

/// `minksum check RESULT P Q`
struct CheckArguments {
  std::string result;
  std::string operands[2];
  bool json = false;
  io::ReadOptions limits;
  CheckOptions how;
  Options options;
};
void convert(const CheckArguments& arguments);

/// What operations on one or two operands share.
struct OperandArguments : EachArguments {
  std::string operands[2];  ///< file names; "-" = standard input; the second is empty = only one
  std::string picture;      ///< empty = none
  std::string stats;        ///< empty = none
  io::ReadOptions limits;
  Options options;
};

/// `minksum dilate A B ...`, and also erode, open and close
struct MorphologyArguments : ResultArguments, OperandArguments {
  enum class Operation { kDilate, kErode, kOpen, kClose };
  Operation operation = Operation::kDilate;
  bool tight = false;
};

/// `minksum union A B ...`, and also intersection, difference and symdiff
struct BooleanArguments : ResultArguments, OperandArguments {
  enum class Operation { kUnion, kIntersection, kDifference, kSymmetricDifference };
  Operation operation = Operation::kUnion;
};

/// `minksum transform FILE ...`, and also reflect and convert
struct TransformArguments : ResultArguments, OperandArguments {
  enum class Operation { kTransform, kReflect, kConvert };
  Operation operation = Operation::kTransform;
  std::optional<Point> scale;
  std::optional<Rational> degrees;
  double tolerance = 1e-3;
  std::optional<Affine> affine;
  std::optional<Point> move;
  std::optional<Point> about;
  Affine map;             ///< all of these
  std::string turn_note;  ///< says by which angle the map turns if that is not the typed one
};

/// `minksum nfp FIXED MOVING ...` and `minksum ifp BIN PART ...`
struct NoFitArguments : ResultArguments, OperandArguments {
  bool inner_fit = false;
  std::vector<std::string> typed_placements;
  std::vector<Point> placements;  ///< asks for contacts there, not for the polygon
  enum class Reference { kFirst, kLowerLeft, kCentroid, kPoint };
  Reference named = Reference::kFirst;
  Point reference;  ///< for kPoint
};

/// `minksum offset A --distance D ...`
struct OffsetArguments : ResultArguments, OperandArguments {
  Rational distance;
  std::optional<Rational> miter_limit;
  OffsetOptions shape;
};

/// `minksum depth A B ...`
struct DepthArguments : OperandArguments {
  std::optional<Point> along;  ///< direction for the time of impact
  bool json = false;
};

}  // namespace minksum::cli
