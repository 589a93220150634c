#ifndef Varimarch_Testing_UnevenGrid_h
#define Varimarch_Testing_UnevenGrid_h

#include "Module/Scenes/MapperScene.h"

#include <vtkDoubleArray.h>
#include <vtkRectilinearGrid.h>

#include <array>
#include <vector>

/// Rectilinear grids, and their even counterparts for MapperScene.

using Places = std::array<std::vector<double>, 3>; ///< coordinates along each axis [mm]

vtkSmartPointer<vtkDoubleArray> ArrayOf(const std::vector<double>& numbers);

/// Positions as uneven as in a boundary layer, the last one at `extent`.
std::vector<double> UnevenPlaces(int count, double extent, double power);

/// A grid of smooth values from 0 to 1.
vtkSmartPointer<vtkRectilinearGrid> WaveGrid(const Places& places);

/// The image of a rectilinear grid's even counterpart: as many voxels between the same ends.
vtkSmartPointer<vtkImageData> EvenImage(const Places& places);

/// The material of a WaveGrid in a scene of its even counterpart. The scene must outlive it.
MapperScene::Material UnevenMaterial(MapperScene& scene, const Places& places);

#endif
