#ifndef Varimarch_Scene_SceneMeasures_h
#define Varimarch_Scene_SceneMeasures_h

#include <array>
#include <string>

namespace varimarch
{

// Measurements that the user has made, drawn over the image. World space, LPS; names may be empty.

struct Distance
{
  std::array<double, 3> fromMm;
  std::array<double, 3> toMm;
  std::string name = {};
};

struct Angle
{
  std::array<double, 3> fromMm;
  std::array<double, 3> vertexMm; ///< apex of the angle
  std::array<double, 3> toMm;
  std::string name = {};
};

/// A box along the volume's axes whose voxels are summarized by statistics.
struct MeasuredBox
{
  std::array<double, 3> fromMm; ///< two opposite corners
  std::array<double, 3> toMm;
  std::string name = {};
};

}

#endif
