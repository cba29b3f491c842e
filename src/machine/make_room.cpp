#include "machine/make_room.hpp"

namespace minksum {

template void move_to_larger(std::vector<std::uint8_t>&, std::size_t, Cancellation&);
template void move_to_larger(std::vector<std::uint32_t>&, std::size_t, Cancellation&);
template void resize_long(std::vector<std::uint8_t>&, std::size_t, Cancellation&,
                          const std::uint8_t&);
template void resize_long(std::vector<std::uint32_t>&, std::size_t, Cancellation&);
template void resize_long(std::vector<std::uint32_t>&, std::size_t, Cancellation&,
                          const std::uint32_t&);

}  // namespace minksum
