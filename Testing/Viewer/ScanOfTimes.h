#ifndef Varimarch_Testing_ScanOfTimes_h
#define Varimarch_Testing_ScanOfTimes_h

#include <cstdint>
#include <string>

namespace varimarch
{

inline constexpr int timesOfScan = 6;

/// The value of the cube at a time of the scan.
inline int ValueAtTime(int time)
{
  return 100 * (time + 1);
}

/// An NRRD file of 8 x 8 x 8 voxels of 2 mm at 6 times, 0.05 s apart: a cube of 4 x 4 x 4 voxels
/// with the value of the time, in 0.
inline std::string NrrdOfTimes()
{
  std::string bytes = "NRRD0004\ntype: short\nendian: little\nencoding: raw\ndimension: 4\n"
                      "sizes: 8 8 8 6\nspacings: 2 2 2 0.05\nkinds: domain domain domain time\n"
                      "units: \"mm\" \"mm\" \"mm\" \"s\"\n\n";
  for (int voxel = 0; voxel < 512 * timesOfScan; ++voxel)
  {
    const auto isMiddle = [](int index) { return index > 1 && index < 6; };
    const bool isInside =
      isMiddle(voxel % 8) && isMiddle(voxel / 8 % 8) && isMiddle(voxel / 64 % 8);
    const auto value = std::int16_t(isInside ? ValueAtTime(voxel / 512) : 0);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

}

#endif
