#include "validation/ring_sweep.hpp"

#include <algorithm>
#include <span>

#include "machine/make_room.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {
namespace {

class Sweeper {
 public:
  Sweeper(const PreparedOperand& operand, Cancellation& cancellation, OperandScratch& scratch)
      : o_(operand),
        cancellation_(cancellation),
        predicates_(operand.sites, *operand.kernel, operand.bounds, cancellation),
        touches_(scratch.touches),
        s_(scratch.sweep),
        sweep_(*this, cancellation, scratch.sweep.segments) {}

  void run() {
    prepare();
    sort_sites();
    for (std::size_t begin = 0, end = 0; begin < s_.order.size(); begin = end) {
      while (end < s_.order.size() && s_.place[s_.order[end]] == begin) ++end;
      cancellation_.check(8 * (end - begin));
      pass(std::span(s_.order).subspan(begin, end - begin));
    }
  }

  // What SegmentSweep asks for.
  [[nodiscard]] SiteId low_end(SiteId e) const { return runs_right(e) ? e : o_.sites.next[e]; }
  [[nodiscard]] SiteId high_end(SiteId e) const { return runs_right(e) ? o_.sites.next[e] : e; }
  /// Returns on which side of an edge a vertex lies: kPositive is above.
  [[nodiscard]] Sign side(SiteId e, SiteId v) {
    return predicates_.orientation(low_end(e), high_end(e), v);
  }
  [[nodiscard]] std::uint32_t place(SiteId v) const { return s_.place[v]; }
  void suspect(SiteId e) {
    s_.suspect[e] = 1;
    s_.any_suspect = true;
  }
  [[nodiscard]] bool is_suspect(SiteId e) const { return s_.suspect[e] != 0; }
  void started(SiteId e, SlotId below) {
    std::uint32_t& parent = s_.parent[s_.ring_of[e]];
    if (parent == kUnknown) parent = ring_above(below);
  }

 private:
  using Spoke = RingSweep::Spoke;

  void prepare() {
    s_.any_suspect = false;
    sweep_.start(o_.size());
    assign_in_pieces(s_.suspect, o_.size(), std::uint8_t{0}, cancellation_);
    assign_in_pieces(s_.is_open, o_.size(), std::uint8_t{0}, cancellation_);
    assign_in_pieces(s_.parent, o_.rings.size(), kUnknown, cancellation_);
    resize_in_pieces(s_.ring_of, o_.size(), cancellation_);
    for (std::uint32_t r = 0; r < o_.rings.size(); ++r) {
      const OperandRing& ring = o_.rings[r];
      cancellation_.check(1 + (ring.end - ring.begin) / 4);
      std::fill(s_.ring_of.begin() + ring.begin, s_.ring_of.begin() + ring.end, r);
    }
  }

  // -- Order -------------------------------------------------------------------------------------
  using Key = RingSweep::Key;
  [[nodiscard]] Sign order_of(const Key& a, const Key& b) {
    const double doubt = o_.bounds.difference;
    if (a.x + doubt < b.x) return kNegative;
    if (b.x + doubt < a.x) return kPositive;
    return predicates_.compare(a.site, b.site);
  }
  void sort_sites() {
    auto& keys = s_.keys;
    resize_in_pieces(keys, o_.size(), cancellation_);
    in_pieces(keys.size(), cancellation_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) keys[v] = {o_.sites.x[v], static_cast<SiteId>(v)};
    });
    sort_in_pieces(keys.begin(), keys.end(), cancellation_, [this](const Key& a, const Key& b) {
      const Sign sign = order_of(a, b);
      return sign != kZero ? sign == kNegative : a.site < b.site;
    });
    resize_in_pieces(s_.order, o_.size(), cancellation_);
    resize_in_pieces(s_.place, o_.size(), cancellation_);
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
      cancellation_.check();
      if (i > 0 && order_of(keys[i - 1], keys[i]) != kZero) first = i;
      s_.order[i] = keys[i].site;
      s_.place[keys[i].site] = first;
    }
  }
  [[nodiscard]] bool runs_right(SiteId e) const { return s_.place[e] < s_.place[o_.sites.next[e]]; }

  // -- Suspects ----------------------------------------------------------------------------------
  void suspect_vertex(SiteId v) {
    suspect(v);
    suspect(o_.previous[v]);
  }
  /// Tells whether a vertex has no edge left that is not suspect.
  [[nodiscard]] bool is_out(SiteId v) const { return is_suspect(v) && is_suspect(o_.previous[v]); }

  // -- One point ---------------------------------------------------------------------------------
  void pass(std::span<const SiteId> here) {
    if (here.size() == 1 && pass_within_chain(here[0])) return;
    const SiteId passing = sweep_.arrive(here[0], ending_at(here));
    list_spokes(here);
    if (here.size() > 1 || passing != kNoSite) meet(here, passing);
    sweep_.leave(passing, [&](auto visit) {
      for (const Spoke& spoke : s_.right) visit(spoke.edge, spoke.far);
    });
  }
  /// Passes a vertex between an edge from the left and an edge to the right, if it is alone.
  [[nodiscard]] bool pass_within_chain(SiteId v) {
    const SiteId in = o_.previous[v];
    const bool to_right = runs_right(v);
    if (runs_right(in) != to_right) return false;
    const SiteId ending = to_right ? in : v;
    return sweep_.has_place(ending) && sweep_.go_on(v, ending, to_right ? v : in);
  }
  /// Returns some edge that ends here and has a place, or kNoSite.
  [[nodiscard]] SiteId ending_at(std::span<const SiteId> here) const {
    for (const SiteId v : here) {
      for (const SiteId e : {v, o_.previous[v]}) {
        if (high_end(e) == v && sweep_.has_place(e)) return e;
      }
    }
    return kNoSite;
  }

  // -- Spokes ------------------------------------------------------------------------------------
  /// Lists the directions to the right, and to the left, each counter-clockwise.
  void list_spokes(std::span<const SiteId> here) {
    s_.right.clear();
    s_.left.clear();
    for (const SiteId v : here) {
      if (is_out(v)) continue;
      const SiteId in = o_.previous[v];
      (runs_right(v) ? s_.right : s_.left).push_back({o_.sites.next[v], v, v});
      (runs_right(in) ? s_.left : s_.right).push_back({in, in, v});
    }
    sort_spokes(here[0], s_.right);
    if (here.size() > 1) sort_spokes(here[0], s_.left);
  }
  void sort_spokes(SiteId point, std::vector<Spoke>& spokes) {
    if (spokes.size() < 2) return;
    sort_in_pieces(spokes.begin(), spokes.end(), cancellation_,
                   [&](const Spoke& a, const Spoke& b) {
                     const Sign sign = predicates_.orientation(point, a.far, b.far);
                     return sign != kZero ? sign == kPositive : a.edge < b.edge;
                   });
  }

  // -- Meetings at one point ---------------------------------------------------------------------
  /// Tests vertices with each other, and with an edge through them.
  void meet(std::span<const SiteId> here, SiteId passing) {
    meet_own_ring(here);
    if (passing != kNoSite) meet_passing(here, passing);
    meet_same_direction(here[0], s_.right);
    meet_same_direction(here[0], s_.left);
    meet_crosswise();
    list_touches(here, passing);
  }
  /// Suspects all but one of the vertices that a ring has at this point. `here` lists the vertices
  /// of one ring one after the other.
  void meet_own_ring(std::span<const SiteId> here) {
    SiteId last = kNoSite;
    for (const SiteId v : here) {
      if (is_out(v)) continue;
      if (last != kNoSite && s_.ring_of[last] == s_.ring_of[v]) {
        suspect_vertex(v);
      } else {
        last = v;
      }
    }
  }
  /// Suspects the vertices whose edges do not both lie on one side of an edge through this point.
  void meet_passing(std::span<const SiteId> here, SiteId passing) {
    cancellation_.check(4 * here.size());
    for (const SiteId v : here) {
      if (is_out(v)) continue;
      const bool parted =
          side(passing, o_.previous[v]) * side(passing, o_.sites.next[v]) != kPositive;
      if (parted || s_.ring_of[v] == s_.ring_of[passing]) suspect_vertex(v);
    }
  }
  /// Suspects all but one of the vertices that have edges in one direction.
  void meet_same_direction(SiteId point, std::span<const Spoke> spokes) {
    cancellation_.check(4 * spokes.size());
    const Spoke* last = nullptr;
    for (const Spoke& spoke : spokes) {
      if (is_out(spoke.vertex)) continue;
      if (last != nullptr && predicates_.orientation(point, last->far, spoke.far) == kZero) {
        suspect_vertex(spoke.vertex);
      } else {
        last = &spoke;
      }
    }
  }
  /// Goes once around the point, with a stack of the vertices that have shown one edge. A vertex is
  /// suspect if another one is on top when its second edge comes: they cross.
  void meet_crosswise() {
    s_.open.clear();
    for (const std::vector<Spoke>* const half : {&s_.right, &s_.left}) {
      cancellation_.check(half->size());
      for (const Spoke& spoke : *half) {
        const SiteId v = spoke.vertex;
        if (is_out(v)) continue;
        while (!s_.open.empty() && is_out(s_.open.back())) close();
        if (s_.is_open[v] == 0) {
          s_.is_open[v] = 1;
          s_.open.push_back(v);
        } else if (s_.open.back() == v) {
          close();
        } else {
          suspect_vertex(v);
        }
      }
    }
    while (!s_.open.empty()) close();
  }
  void close() {
    s_.is_open[s_.open.back()] = 0;
    s_.open.pop_back();
  }
  void list_touches(std::span<const SiteId> here, SiteId passing) {
    const auto polygon = [&](SiteId v) { return o_.rings[s_.ring_of[v]].polygon; };
    cancellation_.check(2 * here.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i > 0 && polygon(here[i - 1]) == polygon(here[i])) {
        append(touches_, {here[i], here[i - 1], true}, cancellation_);
      }
      if (passing != kNoSite && polygon(passing) == polygon(here[i])) {
        append(touches_, {here[i], passing, false}, cancellation_);
      }
    }
  }

  /// Returns the smallest ring around the points right above a slot.
  [[nodiscard]] std::uint32_t ring_above(SlotId slot) const {
    if (slot == SweepStatus::kGround) return RingSweep::kNoRing;
    const SiteId e = sweep_.status().segment(slot);
    const std::uint32_t ring = s_.ring_of[e];
    return runs_right(e) != o_.rings[ring].is_hole() ? ring : s_.parent[ring];
  }

  static constexpr std::uint32_t kUnknown = RingSweep::kNoRing - 1;

  const PreparedOperand& o_;
  Cancellation& cancellation_;
  Predicates predicates_;
  std::vector<RingTouch>& touches_;
  RingSweep& s_;
  SegmentSweep<Sweeper> sweep_;
};

}  // namespace

void sweep_rings(const PreparedOperand& operand, Cancellation& cancellation,
                 OperandScratch& scratch) {
  Sweeper(operand, cancellation, scratch).run();
}

}  // namespace minksum
