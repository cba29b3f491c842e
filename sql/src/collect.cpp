// Keeps what an aggregate has collected: parts of a union, or one sum.
#include "state.hpp"

namespace minksum::sql {

namespace {

// A union of many parts at once costs less than one by one. A state keeps up to so many.
constexpr std::size_t kParts = 4096;

void unite_parts(mink_state& state, const Options& options) {
  if (state.collected.size() < 2) return;
  Geometry all = unite(state.collected, options);
  state.collected.clear();
  state.collected.push_back(std::move(all));
}

void add(mink_state& state, Geometry part, mink_operation operation, const Options& options) {
  if (operation == MINK_SUM && !state.collected.empty()) {
    state.collected.front() = minkowski_sum(state.collected.front(), part, options);
    return;
  }
  state.collected.push_back(std::move(part));
  if (state.collected.size() >= kParts) unite_parts(state, options);
}

}  // namespace

}  // namespace minksum::sql

using namespace minksum::sql;  // NOLINT(google-build-using-namespace)

mink_status mink_collect(mink_state* state, const mink_request* request, mink_error* error) {
  return guarded(error, [&] {
    const minksum::Options options = options_of(*state, *request);
    auto [part, srid] = read(request->operands[0], request->text, 0, options);
    join_srid(state->srid, srid);
    add(*state, minksum::resolve(part, options, 0), request->operation, options);
    return MINK_OK;
  });
}

mink_status mink_merge(mink_state* state, const mink_state* other, const mink_request* request,
                       mink_error* error) {
  return guarded(error, [&] {
    const minksum::Options options = options_of(*state, *request);
    join_srid(state->srid, other->srid);
    for (const minksum::Geometry& part : other->collected) {
      add(*state, part, request->operation, options);
    }
    return MINK_OK;
  });
}

mink_status mink_save(mink_state* state, const mink_request* request, mink_answer* answer,
                      mink_error* error) {
  return guarded(error, [&] {
    const minksum::Options options = options_of(*state, *request);
    unite_parts(*state, options);
    // Exact text, so that a parallel plan loses nothing.
    answer->sets[0] = write(*state, state->collected.at(0), true, {}, options);
    return MINK_OK;
  });
}

mink_status mink_load(mink_state* state, mink_bytes saved, const mink_request* request,
                      mink_error* error) {
  return guarded(error, [&] {
    auto [part, srid] = read(saved, true, 0, options_of(*state, *request));
    state->srid = srid;
    state->collected.clear();
    state->collected.push_back(std::move(part));
    return MINK_OK;
  });
}

mink_status mink_finish(mink_state* state, const mink_request* request, mink_answer* answer,
                        mink_error* error) {
  return guarded(error, [&] {
    const minksum::Options options = options_of(*state, *request);
    unite_parts(*state, options);
    if (state->collected.empty()) return MINK_NULL;
    const minksum::RoundOptions target{side_of(request->round, "round"), {}};
    answer->sets[0] = write(*state, state->collected.front(), request->text, target, options);
    return MINK_OK;
  });
}
