#ifndef Varimarch_Readers_Decoder_ImageForm_h
#define Varimarch_Readers_Decoder_ImageForm_h

#include "Readers/VoxelLayout.h"

#include <array>
#include <string>

class vtkImageData;

namespace varimarch
{

/// Everything about an image but its voxels.
struct ImageForm
{
  VoxelLayout layout = {};
  std::string name; ///< name of the scalars
  std::array<double, 3> origin = {};
  std::array<double, 3> spacing = {};
  std::array<double, 9> direction = {};

  /// Gives an image of the layout the rest of this form.
  void Place(vtkImageData* image) const;
};

ImageForm FormOf(vtkImageData* image);

template <class Wire>
void Fields(Wire& wire, ImageForm& form)
{
  wire(form.layout, form.name, form.origin, form.spacing, form.direction);
}

}

#endif
