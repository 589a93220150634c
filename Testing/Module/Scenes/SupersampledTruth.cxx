#include "Module/Scenes/SupersampledTruth.h"

std::vector<float> SupersampledTruth(int size, const std::function<void(MapperScene&)>& prepare)
{
  constexpr int PerSide = 8;
  MapperScene scene(SmallTorso(), PerSide * size);
  prepare(scene);
  const std::vector<float> fine = scene.Truth();
  std::vector<float> mean(4 * size * size);
  for (int row = 0; row < PerSide * size; ++row)
  {
    for (int column = 0; column < PerSide * size; ++column)
    {
      for (int channel = 0; channel < 4; ++channel)
      {
        mean[4 * (row / PerSide * size + column / PerSide) + channel] +=
          fine[4 * (row * PerSide * size + column) + channel] / (PerSide * PerSide);
      }
    }
  }
  return mean;
}
