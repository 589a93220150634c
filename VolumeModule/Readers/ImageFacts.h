#ifndef Varimarch_Readers_ImageFacts_h
#define Varimarch_Readers_ImageFacts_h

#include "VarimarchVolumeModule.h"

#include "Readers/VolumeFile.h"

#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace varimarch
{

// Facts that a reader knows about an image and that its look depends on: whether it shows a
// patient, which values are padding, and what its components are. They are kept in the field data
// of the image and in the names of its components, so that they go with it through pipelines and
// VTI files. An image without them is one of which nothing is known.

/// Keeps the facts about a volume with its image.
VARIMARCHVOLUME_EXPORT void KeepFacts(const Volume& volume, vtkImageData* image);

/// True if the image is known to show a patient.
VARIMARCHVOLUME_EXPORT bool ShowsPatient(vtkImageData* image);

/// The lowest value of the image if voxels outside it, which the file marks as padding, are below.
VARIMARCHVOLUME_EXPORT std::optional<double> LowestInside(vtkImageData* image);

/// True if the components of each voxel are a colour: luminance and alpha; red, green and blue; or
/// these and alpha. Three or four bytes of which nothing is known are colours, as everywhere in
/// VTK.
VARIMARCHVOLUME_EXPORT bool HoldsColors(vtkImageData* image);

/// The independent components, one element each; empty for a single component and for colours.
VARIMARCHVOLUME_EXPORT std::vector<VolumeChannel> ChannelsIn(vtkImageData* image);

}

#endif
