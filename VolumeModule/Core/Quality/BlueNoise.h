#ifndef Varimarch_Core_Quality_BlueNoise_h
#define Varimarch_Core_Quality_BlueNoise_h

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Thresholds of a square tile of blue noise: neighbours differ as much as possible. The size *
/// size values are evenly spaced in 16 bits and occur once each; those below any threshold are
/// spread evenly, also across the borders of the repeated tile. Each call returns the same tile.
/// Source: R. Ulichney, "The void-and-cluster method for dither array generation", Proc. SPIE 1913,
/// 1993.
/// @param size  side of the tile, a power of two from 4 to 64
std::vector<std::uint16_t> BlueNoiseTile(int size);

}

#endif
