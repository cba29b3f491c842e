// Makes rows one by one: slices of a configuration space, and entries of a no-fit table.
#include "state.hpp"

namespace minksum::sql {

namespace {

/// Takes over what later rows need.
void begin(mink_state& state, const mink_request& request) {
  state.srid.reset();
  state.options = options_of(state, request);
  state.target.side = side_of(request.round, "round");
  state.with_free = request.wanted;
}

struct Entry {
  TurnedPart fixed;
  TurnedPart moving;
};

/// Returns an entry by its number. The moving part's turn changes fastest.
Entry entry_of(const NoFitTable& table, std::uint64_t row) {
  const auto turns = static_cast<std::uint64_t>(table.turns());
  Entry entry;
  entry.moving.turn = static_cast<int>(row % turns);
  entry.moving.part = row / turns % table.size();
  row /= turns * table.size();
  entry.fixed.turn = static_cast<int>(row % turns);
  entry.fixed.part = row / turns;
  return entry;
}

}  // namespace

}  // namespace minksum::sql

using namespace minksum::sql;  // NOLINT(google-build-using-namespace)

mink_status mink_begin_slices(mink_state* state, const mink_request* request, uint64_t* count,
                              mink_error* error) {
  return guarded(error, [&] {
    begin(*state, *request);
    if (request->whole < 1) {
      throw Refusal{MINK_BAD_INPUT, "angles must be positive", {},
                    "Use 72 for steps of 5 degrees."};
    }
    const Operand& robot = operand(*state, *request, 0, state->options);
    const Operand& obstacles = operand(*state, *request, 1, state->options);
    state->space.emplace(robot.geometry, obstacles.geometry, minksum::ConfigurationOptions{},
                         state->options);
    *count = static_cast<std::uint64_t>(request->whole);
    state->step = minksum::Rational(360) / minksum::Rational(request->whole);
    return MINK_OK;
  });
}

mink_status mink_slice(mink_state* state, uint64_t row, mink_answer* answer, mink_error* error) {
  return guarded(error, [&] {
    const minksum::Rational angle = minksum::Rational(static_cast<std::int64_t>(row)) * state->step;
    const minksum::Slice slice =
        state->space->slice(minksum::nearest_turn(angle), state->with_free);
    answer->whole[0] = static_cast<int>(row);
    answer->numbers[0] = slice.turn.degrees;
    answer->sets[0] = write(*state, slice.obstacles, false, state->target, state->options);
    if (state->with_free) {
      answer->sets[1] = write(*state, slice.free, false, state->target, state->options, 1);
    }
    return MINK_OK;
  });
}

mink_status mink_begin_no_fit_table(mink_state* state, const mink_request* request,
                                    uint64_t* count, mink_error* error) {
  return guarded(error, [&] {
    begin(*state, *request);
    std::vector<minksum::Geometry> parts;
    for (int i = 0; i < request->operand_count; ++i) {
      auto [part, srid] = read(request->operands[i], false, i, state->options);
      join_srid(state->srid, srid);
      parts.push_back(std::move(part));
    }
    state->table.emplace(parts, request->whole, state->options);
    const auto laid = static_cast<std::uint64_t>(parts.size()) *
                      static_cast<std::uint64_t>(state->table->turns());
    *count = laid * laid;
    return MINK_OK;
  });
}

mink_status mink_no_fit_entry(mink_state* state, uint64_t row, mink_answer* answer,
                              mink_error* error) {
  return guarded(error, [&] {
    const Entry entry = entry_of(*state->table, row);
    const minksum::Geometry polygon = state->table->at(entry.fixed, entry.moving, state->options);
    answer->whole[0] = static_cast<int>(entry.fixed.part) + 1;
    answer->whole[1] = entry.fixed.turn;
    answer->whole[2] = static_cast<int>(entry.moving.part) + 1;
    answer->whole[3] = entry.moving.turn;
    answer->sets[0] = write(*state, polygon, false, state->target, state->options, 0, true);
    return MINK_OK;
  });
}
