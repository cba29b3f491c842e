// Finds covered cells by moving the inside of one operand by points of the other.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "sum/cover/run_spreader.hpp"

namespace minksum {
namespace {

/// Returns the units of work of a walk along an edge: about one for each cell on its way.
std::uint64_t work_of_walk(const EdgesOfOperand& o, SiteId e, const UniformGrid& grid) {
  const Vec<double> a = o.at(e);
  const Vec<double> b = o.at(o.next[e]);
  return static_cast<std::uint64_t>(std::abs(b.x - a.x) * grid.inverse.x +
                                    std::abs(b.y - a.y) * grid.inverse.y);
}

/// Fills rows by the even-odd rule: each bit becomes the parity of the toggles up to it.
void fill_between_toggles(Bitmap& bitmap) {
  for (std::int32_t j = 0; j < bitmap.rows(); ++j) {
    std::uint64_t carry = 0;
    std::uint64_t* row = bitmap.row(j);
    for (std::size_t w = 0; w < bitmap.words_per_row(); ++w) {
      std::uint64_t parity = row[w];
      for (int shift = 1; shift < 64; shift *= 2) parity ^= parity << shift;
      row[w] = parity ^ carry;
      carry = (row[w] >> 63) != 0 ? ~std::uint64_t{0} : 0;
    }
  }
}

/// Finds the cells that lie inside one operand with their margin.
///
/// Cells within 4 · kMargin of an edge are left out. Any other cell lies with its margin on one
/// side of the boundary. The parity at the cell's centre tells which side, because rounding moves
/// edges by far less than the margin.
class Rasteriser {
 public:
  Rasteriser(const EdgesOfOperand& o, const UniformGrid& grid, std::size_t words, Bitmap& boundary,
             Cancellation& cancellation, OperandRaster& raster)
      : cancellation_(cancellation),
        o_(o),
        raster_(raster),
        inside_(raster.inside),
        boundary_(boundary),
        words_(words) {
    grid_.cell = grid.cell;
    grid_.inverse = grid.inverse;
    grid_.columns = static_cast<std::int32_t>(o.extent.x * grid_.inverse.x) + 2;
    grid_.rows = static_cast<std::int32_t>(o.extent.y * grid_.inverse.y) + 2;
  }

  void run() {
    inside_.reset(grid_.columns, grid_.rows, words_);
    boundary_.reset(grid_.columns, grid_.rows, words_);
    for (SiteId e = o_.begin; e < o_.end; ++e) {
      const Vec<double> a = o_.at(e);
      const Vec<double> b = o_.at(o_.next[e]);
      cancellation_.check(2 + work_of_walk(o_, e, grid_));
      add(a, b);
    }
    fill_between_toggles(inside_);
    for (std::size_t w = 0; w < inside_.words().size(); ++w) {
      inside_.words()[w] &= ~boundary_.words()[w];
    }
    unite_blocks(inside_, 1, raster_.blocks);
  }
  void sample_boundary() {
    Bitmap& sampled = raster_.sampled;
    sampled.reset(grid_.columns, grid_.rows, words_);
    const auto& [cell, inverse, columns, rows] = grid_;
    for (SiteId e = o_.begin; e < o_.end; ++e) {
      const Vec<double> a = o_.at(e);
      const Vec<double> b = o_.at(o_.next[e]);
      const Vec<double> way{(b.x - a.x) * inverse.x, (b.y - a.y) * inverse.y};
      const int steps = static_cast<int>(std::max(std::abs(way.x), std::abs(way.y))) + 1;
      const Vec<double> step{way.x / steps, way.y / steps};
      for (int k = 0; k < steps; ++k) {
        const auto i = static_cast<std::int32_t>(a.x * inverse.x + k * step.x);
        const auto j = static_cast<std::int32_t>(a.y * inverse.y + k * step.y);
        if (i >= 0 && j >= 0 && i < sampled.columns() && j < sampled.rows()) sampled.set(i, j);
      }
    }
  }

 private:
  /// Marks the cells near an edge, and flips one where it crosses the centre line of each row. That
  /// one is near the edge and is left out, so its own parity does not matter.
  void add(const Vec<double>& a, const Vec<double>& b) {
    constexpr double kMargin = 4 * UniformGrid::kMargin;
    const UniformGrid::RowWalk walk(grid_, a, b, kMargin);
    const auto flip = [](std::uint64_t* row, double x) {
      const auto i = static_cast<std::int32_t>(x);
      row[i >> 6] ^= std::uint64_t{1} << (i & 63);
    };
    const auto [inner, behind] = walk.inner_rows();
    for (std::int32_t j = walk.first; j <= walk.last; ++j) {
      const UniformGrid::RowSpan span = walk.span(j, j);
      std::uint64_t* near = boundary_.row(j);
      std::uint64_t* inside = inside_.row(j);
      if (j != inner || inner >= behind) {
        set_bits(near, span.left, span.right);
        if (walk.passes(j + 0.5)) flip(inside, walk.column_at(j + 0.5));
        continue;
      }
      // All inner rows at once. Steps round by far less than the slack, and the middle of a span is
      // where the edge crosses the centre line.
      double left = span.x0 - kMargin - UniformGrid::kSlack;
      double right = span.x1 + kMargin + UniformGrid::kSlack;
      for (;; ++j) {
        set_bits(near, static_cast<std::int32_t>(left), static_cast<std::int32_t>(right));
        flip(inside, (left + right) / 2);
        if (j + 1 == behind) break;
        left += walk.slope();
        right += walk.slope();
        near += words_;
        inside += words_;
      }
    }
  }

  Cancellation& cancellation_;
  const EdgesOfOperand& o_;
  UniformGrid grid_;
  OperandRaster& raster_;
  Bitmap& inside_;
  Bitmap& boundary_;
  std::size_t words_;
};

/// Returns the first bit at or after `from` that differs from `unwanted`, or 64 · words if none
/// does.
std::size_t next_bit(const std::uint64_t* row, std::size_t words, std::size_t from,
                     std::uint64_t unwanted) {
  std::size_t w = from >> 6;
  if (w >= words) return words * 64;
  std::uint64_t word = (row[w] ^ unwanted) & (~std::uint64_t{0} << (from & 63));
  while (word == 0) {
    if (++w == words) return words * 64;
    word = row[w] ^ unwanted;
  }
  return w * 64 + static_cast<std::size_t>(std::countr_zero(word));
}
template <class Visit>
void for_each_run(const std::vector<std::uint64_t>& row, Visit visit) {
  for (std::size_t i = next_bit(row.data(), row.size(), 0, 0); i < row.size() * 64;) {
    const std::size_t end = next_bit(row.data(), row.size(), i, ~std::uint64_t{0});
    visit(static_cast<std::int32_t>(i), static_cast<std::int32_t>(end - 1));
    i = next_bit(row.data(), row.size(), end, 0);
  }
}

/// Returns the rows of all corners of an operand's cells.
RowRange all_rows(const OperandRaster& operand) { return {0, operand.inside.rows() + 1}; }

/// Calls move(first, last, row) for the corners of cells inside an operand, run by run. They are
/// points of that operand, and they keep the other one's raster aligned.
template <class Move>
void for_lattice_points(const OperandRaster& operand, const RowRange& rows,
                        std::vector<std::uint64_t>& corners, Move move) {
  const Bitmap& inside = operand.inside;
  const std::size_t words = inside.words_per_row();
  corners.resize(words);
  for (std::int32_t j = rows.first; j < rows.last; ++j) {
    std::uint64_t carry = 0;
    for (std::size_t w = 0; w < words; ++w) {
      const std::uint64_t cells =
          (j > 0 ? inside.row(j - 1)[w] : 0) | (j < inside.rows() ? inside.row(j)[w] : 0);
      corners[w] = cells | (cells << 1) | carry;
      carry = cells >> 63;
    }
    for_each_run(corners, [&](std::int32_t first, std::int32_t last) { move(first, last, j); });
  }
}
/// Does the same for one boundary point of the operand for each cell that has one. A cell moved
/// back by such a point lies in a block of four cells.
template <class Move>
void for_boundary_points(const OperandRaster& operand, const RowRange& rows,
                         std::vector<std::uint64_t>& cells, Move move) {
  const std::size_t words = operand.inside.words_per_row();
  cells.resize(words);
  for (std::int32_t j = rows.first; j < std::min(rows.last, operand.inside.rows()); ++j) {
    // Cells inside join runs to longer ones. By themselves they cover nothing new.
    for (std::size_t w = 0; w < words; ++w) {
      cells[w] = operand.sampled.row(j)[w] | operand.inside.row(j)[w];
    }
    for_each_run(cells,
                 [&](std::int32_t first, std::int32_t last) { move(first + 1, last + 1, j + 1); });
  }
}

/// Returns how many words are moved if points of an operand move the other one's raster.
std::uint64_t price_of(const OperandRaster& moved, const OperandRaster& by,
                       std::vector<std::uint64_t>& row) {
  std::uint64_t words = 0;
  const auto all_words = [](const Bitmap& bitmap) {
    const RowRange rows = occupied_rows(bitmap);
    return static_cast<std::uint64_t>(rows.last - rows.first) * bitmap.words_per_row();
  };
  const auto add = [&](std::uint64_t size) {
    return [&words, size](std::int32_t first, std::int32_t last, std::int32_t) {
      words += RunSpreader::moves(last + 1 - first) * size;
    };
  };
  if (const auto size = all_words(moved.inside); size != 0) {
    for_lattice_points(by, all_rows(by), row, add(size));
  }
  if (const auto size = all_words(moved.blocks); size != 0) {
    for_boundary_points(by, all_rows(by), row, add(size));
  }
  return words;
}

/// Marks the cells that the interior of `moved` covers if points of the other operand move it.
void spread(const OperandRaster& moved, const OperandRaster& by, Cancellation& cancellation,
            CoverScratch& scratch, const MemberBitmaps& targets) {
  const auto spread_by = [&](const Bitmap& source, auto for_points) {
    RunSpreader spreader(source, scratch.vectors, scratch.widened);
    if (spreader.words() == 0) return;
    const auto work = [&](std::int32_t columns) {
      constexpr std::uint64_t kWordsPerUnit = 16;  // some eight are united at a time
      return RunSpreader::moves(columns) * (spreader.words() / kWordsPerUnit + 1);
    };
    const RowRange all = all_rows(by);
    std::size_t tasks = 1;
    if (members_of(cancellation) > 1) {
      std::uint64_t units = 0;
      std::int32_t longest = 1;
      for_points(by, all, scratch.row, [&](std::int32_t first, std::int32_t last, std::int32_t) {
        units += work(last + 1 - first);
        longest = std::max(longest, last + 1 - first);
      });
      tasks = tasks_for(units, cancellation);
      if (tasks > 1) spreader.widen_for(longest);
    }
    share(tasks, cancellation, [&](std::size_t task, std::size_t member, Cancellation& own) {
      Bitmap& target = targets.of(member);
      const auto begin = [&](std::size_t i) {
        return static_cast<std::int32_t>(begin_of(i, tasks, static_cast<std::size_t>(all.last)));
      };
      for_points(by, RowRange{begin(task), begin(task + 1)},
                 member == 0 ? scratch.row : scratch.helpers[member - 1].row,
                 [&](std::int32_t first, std::int32_t last, std::int32_t row) {
                   own.check(work(last + 1 - first));
                   spreader.spread(first, last, row, target);
                 });
    });
  };
  spread_by(moved.inside, [](auto&&... rest) { for_lattice_points(rest...); });
  spread_by(moved.blocks, [](auto&&... rest) { for_boundary_points(rest...); });
}

void spread_both(const OperandRaster& first, const OperandRaster& second,
                 Cancellation& cancellation, CoverScratch& scratch, Cover& cover) {
  MemberBitmaps targets(cancellation, scratch.helpers, cover.covered);
  spread(first, second, cancellation, scratch, targets);
  spread(second, first, cancellation, scratch, targets);
  targets.unite();
}

}  // namespace

std::size_t words_per_row(std::int32_t columns) {
  return (static_cast<std::size_t>(columns) + 1 + 63) / 64;
}

std::uint64_t rasterise(const EdgesOfOperands& edges, const UniformGrid& grid,
                        Cancellation& cancellation, CoverScratch& scratch) {
  auto& [first, second] = scratch.raster;
  const std::size_t words = words_per_row(grid.columns);
  const auto rasteriser = [&](std::size_t operand, Cancellation& own) {
    return Rasteriser(edges[operand], grid, words, scratch.boundary[operand], own,
                      scratch.raster[operand]);
  };
  std::uint64_t units = 0;  // one thread need not know
  if (members_of(cancellation) > 1) {
    // Edges are walked along, and some passes go over all words.
    units = words * static_cast<std::uint64_t>(grid.rows) / 2;
    for (const EdgesOfOperand& o : edges) {
      for (SiteId e = o.begin; e < o.end; ++e) units += 2 + work_of_walk(o, e, grid);
    }
  }
  share_each(2, units / 2, cancellation,
             [&](std::size_t operand, Cancellation& own) { rasteriser(operand, own).run(); });
  share_each(2, units / 4, cancellation, [&](std::size_t operand, Cancellation& own) {
    if (scratch.raster[1 - operand].blocks.has_any()) rasteriser(operand, own).sample_boundary();
  });
  return price_of(first, second, scratch.row) + price_of(second, first, scratch.row);
}

void spread_rasters(Cancellation& cancellation, CoverScratch& scratch, Cover& cover) {
  spread_both(scratch.raster[0], scratch.raster[1], cancellation, scratch, cover);
}

void cover_by_translates(const Operands& operands, const OperandRaster& first,
                         Cancellation& cancellation, CoverScratch& scratch, Cover& cover) {
  OperandRaster& second = scratch.raster[1];
  const EdgesOfOperands edges = edges_of(operands);
  Rasteriser other(edges[1], cover.grid, first.inside.words_per_row(), scratch.boundary[1],
                   cancellation, second);
  other.run();
  if (first.blocks.has_any()) other.sample_boundary();
  spread_both(first, second, cancellation, scratch, cover);
}

void rasterise_first(const Operands& operands, const Cover& cover, Cancellation& cancellation,
                     Bitmap& boundary, OperandRaster& raster) {
  const EdgesOfOperands edges = edges_of(operands);
  Rasteriser rasteriser(edges[0], cover.grid, cover.covered.words_per_row(), boundary, cancellation,
                        raster);
  rasteriser.run();
  rasteriser.sample_boundary();
}

void unite_blocks(const Bitmap& blocks, std::int32_t side, Bitmap& greater) {
  const std::size_t words = blocks.words_per_row();
  greater.reset(blocks.columns(), blocks.rows(), words);
  const auto across = [&](const std::uint64_t* row, std::size_t w) {
    const std::uint64_t next = w + 1 < words ? row[w + 1] : 0;
    return row[w] & ((row[w] >> side) | (next << (64 - side)));
  };
  for (std::int32_t j = 0; j + side < blocks.rows(); ++j) {
    for (std::size_t w = 0; w < words; ++w) {
      greater.row(j)[w] = across(blocks.row(j), w) & across(blocks.row(j + side), w);
    }
  }
}

}  // namespace minksum
