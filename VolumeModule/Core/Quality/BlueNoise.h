#ifndef Varimarch_Core_Quality_BlueNoise_h
#define Varimarch_Core_Quality_BlueNoise_h

#include <cstdint>
#include <vector>

namespace varimarch
{

/// Thresholds of a square tile whose neighbours differ as much as they can: each of size * size
/// values, evenly spaced in 16 bits, is there once, and those below any of them are spread evenly,
/// across the borders of the tile too. By void and cluster: R. Ulichney, "The void-and-cluster
/// method for dither array generation", Proc. SPIE 1913, 1993. The same for every call.
/// @param size  of a side, a power of two from 4 to 64
std::vector<std::uint16_t> BlueNoiseTile(int size);

}

#endif
