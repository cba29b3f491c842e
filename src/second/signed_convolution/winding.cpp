#include "second/signed_convolution/winding.hpp"

namespace minksum::signed_sum {

WindingNumbers::WindingNumbers(std::span<const Layer> layers) : layers_(layers) {
  PairId pairs = 0;
  for (const Layer& layer : layers) pairs = std::max(pairs, layer.pair + 1);
  winding_.assign(layers.size(), 0);
  pair_filled_.assign(pairs, 0);
  pair_holes_.assign(pairs, 0);
}

void WindingNumbers::add(LayerId layer, int change) {
  const PairId pair = layers_[layer].pair;
  const bool was_inside = pair_inside(pair);
  if (layers_[layer].is_hole) {
    if (winding_[layer] == -1) --pair_holes_[pair];
    winding_[layer] += change;
    if (winding_[layer] == -1) ++pair_holes_[pair];
  } else {
    winding_[layer] += change;
    pair_filled_[pair] = winding_[layer];
  }
  pairs_inside_ += static_cast<int>(pair_inside(pair)) - static_cast<int>(was_inside);
}

void WindingNumbers::check(LayerId layer) const {
  if (winding_[layer] < (layers_[layer].is_hole ? -1 : 0)) {
    broken("a winding number is smaller than it can be");
  }
}

void WindingNumbers::clear() {
  std::fill(winding_.begin(), winding_.end(), 0);
  std::fill(pair_filled_.begin(), pair_filled_.end(), 0);
  std::fill(pair_holes_.begin(), pair_holes_.end(), 0);
  pairs_inside_ = 0;
}

}  // namespace minksum::signed_sum
