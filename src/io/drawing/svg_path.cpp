// Reads the commands of SVG's paths.
#include <array>

#include "io/drawing/svg_values.hpp"

namespace minksum::io {
namespace {

class PathReader {
 public:
  PathReader(TextCursor cursor, bool filled, Outlines& outlines)
      : cursor_(cursor), filled_(filled), outlines_(outlines) {}

  void read() {
    cursor_.skip_space();
    if (cursor_.rest() == "none") return;
    while (!cursor_.at_end()) {
      const char letter = cursor_.peek();
      if (!is_letter(letter)) cursor_.fail_expected("a command of a path");
      if (!begun_ && letter != 'M' && letter != 'm') {
        cursor_.fail_expected("'M', with which a path begins");
      }
      cursor_.advance();
      run(letter);
      cursor_.skip_space();
    }
    end(false);
  }

 private:
  void run(char letter) {
    relative_ = letter >= 'a';
    const char command = relative_ ? static_cast<char>(letter - 'a' + 'A') : letter;
    if (command == 'Z') return end(true);
    bool first = true;
    do {
      step(first || command != 'M' ? command : 'L');
      first = false;
      skip_comma(cursor_);
    } while (!cursor_.at_end() && !is_letter(cursor_.peek()));
  }

  void step(char command) {
    if (command != 'M') begin();
    Point next = at_;
    Point control;  // reflected by S or T
    char kind = ' ';
    switch (command) {
      case 'M':
        next = take_point();  // from where the part before ends, which need not be closed
        end(false);
        at_ = start_ = next;
        begun_ = true;
        before_ = ' ';
        return;
      case 'L':
        next = take_point();
        outlines_.line_to(next);
        break;
      case 'H':
        next.x = take(at_.x);
        outlines_.line_to(next);
        break;
      case 'V':
        next.y = take(at_.y);
        outlines_.line_to(next);
        break;
      case 'C':
      case 'S': {
        kind = 'C';
        const Point first = command == 'C' ? take_point() : reflected('C');
        control = take_point();
        next = take_point();
        outlines_.bezier_to(std::array{first, control, next});
        break;
      }
      case 'Q':
      case 'T':
        kind = 'Q';
        control = command == 'Q' ? take_point() : reflected('Q');
        next = take_point();
        outlines_.bezier_to(std::array{control, next});
        break;
      case 'A': {
        const Rational rx = number();
        const Rational ry = number();
        const Rational degrees = number();
        const bool large = flag();
        const bool sweep = flag();
        next = take_point();
        take_arc(at_, next, rx, ry, degrees, large, sweep, outlines_);
        break;
      }
      default:
        cursor_.move_to(cursor_.position() - 1);
        cursor_.fail_expected("a command of a path");
    }
    at_ = next;
    before_ = kind;
    control_ = control;
  }

  Rational number() {
    skip_comma(cursor_);
    return take_number(cursor_);
  }
  /// Flags are one digit, which the next number may follow at once.
  bool flag() {
    skip_comma(cursor_);
    if (cursor_.accept('0')) return false;
    if (!cursor_.accept('1')) cursor_.fail_expected("a flag, 0 or 1");
    return true;
  }
  Rational take(const Rational& from) {
    const Rational value = number();
    return relative_ ? from + value : value;
  }
  Point take_point() {
    const Rational x = take(at_.x);
    return {x, take(at_.y)};
  }
  /// Returns the last control point of the command before, reflected, if that was of the same kind.
  [[nodiscard]] Point reflected(char kind) const {
    if (before_ != kind) return at_;
    return {at_.x + at_.x - control_.x, at_.y + at_.y - control_.y};
  }

  /// Begins a part. A command behind Z begins where the part before did.
  void begin() {
    if (!outlines_.is_open()) outlines_.move_to(start_);
  }
  /// Ends a part, if one has begun.
  void end(bool closed) {
    before_ = ' ';
    if (closed) begin();
    if (outlines_.is_open()) {
      if (closed || filled_ || at_ == start_) {
        outlines_.end_ring();
      } else {
        outlines_.end_polyline();
      }
    }
    at_ = start_;
  }

  TextCursor cursor_;
  bool filled_;
  Outlines& outlines_;
  bool begun_ = false;
  bool relative_ = false;
  Point start_;
  Point at_;
  Point control_;      ///< of the command before
  char before_ = ' ';  ///< the kind of curve of the command before
};

}  // namespace

void take_path(TextCursor cursor, bool filled, Outlines& outlines) {
  PathReader(cursor, filled, outlines).read();
}

}  // namespace minksum::io
