// Measures the time of a reference image: MeasureReference FILE PRESET SIZE TOLERANCE [unshaded]

#include "Scene/Looks/Presets.h"
#include "Scene/Reference/ReferencePicture.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <chrono>
#include <cstring>
#include <exception>
#include <iostream>

using namespace varimarch;

int main(int argc, char** argv)
{
  if (argc < 5)
  {
    std::cerr << "usage: MeasureReference FILE PRESET SIZE TOLERANCE [unshaded]\n";
    return 2;
  }
  try
  {
    Scene scene;
    scene.volume = FileSource{ argv[1], {} };
    scene.look = BuiltInPreset(argv[2]).look;
    scene.look.shading.enabled = !(argc > 5 && std::strcmp(argv[5], "unshaded") == 0);
    scene.size = { std::stoi(argv[3]), std::stoi(argv[3]) };
    const LoadedVolume volume = LoadVolume(scene.volume);

    const auto start = std::chrono::steady_clock::now();
    const auto picture = DrawReferencePicture(scene, volume.image, std::stod(argv[4]));
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    std::cout << elapsed.count() << " s, largest error estimate " << picture.value().largestError
              << "\n";
    return 0;
  }
  catch (const std::exception& problem)
  {
    std::cerr << "MeasureReference: " << problem.what() << "\n";
    return 1;
  }
}
