#ifndef Varimarch_Scene_VolumeProperty_h
#define Varimarch_Scene_VolumeProperty_h

#include "Readers/VolumeFile.h"
#include "Scene/Model/Scene.h"

#include <vector>

class vtkImageData;
class vtkVolumeProperty;

namespace varimarch
{

class ImageStatistics;

/// Converts a look's values to units of the data, and its lengths to millimetres, for this volume.
/// Hounsfield units are left if the values can be such, or if no others are found that stand for
/// them. The look has settings for each channel of a volume with several.
Look InUnitsOfData(const Look& look, vtkImageData* image);
Look InUnitsOfData(const Look& look, const ImageStatistics& statistics);

/// True unless a look is in Hounsfield units and the volume has neither these nor values that stand
/// for them.
bool Suits(const Look& look, const ImageStatistics& statistics);

/// Mean spacing of the voxels [mm]. VTK measures gradients in units of the data per mean spacing.
double MeanSpacingMm(vtkImageData* image);

/// Copies the curves, surfaces and coefficients of a look, which must be in units of the data, to
/// the property of an image: to all channels of several. Colours stay as they are, and opacities
/// depend on their alpha; see ColoredVoxels, which the mapper must draw.
void ApplyLook(const Look& look, vtkImageData* image, vtkVolumeProperty* property);

/// Copies the coefficients of the light alone, to all components.
void ApplyShading(const Shading& shading, vtkVolumeProperty* property);

/// The settings of all channels of a volume: those given, and for each further one its name and its
/// colour, or else one of four colours that are told apart.
std::vector<LookChannel> WithAllChannels(
  std::vector<LookChannel> given, const std::vector<VolumeChannel>& channels);

/// The look of one channel: the curves in its window, its colour, and no opacity if it is not
/// visible. A channel without settings has the curves as they are.
Look LookOfChannel(const Look& look, std::size_t channel);

}

#endif
