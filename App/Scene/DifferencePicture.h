#ifndef Varimarch_Scene_DifferencePicture_h
#define Varimarch_Scene_DifferencePicture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

class Canvas;

/// Shows where two float images differ, as a byte image. The colour of a pixel is the largest
/// difference of its channels on a fixed logarithmic scale from 0.1/255 to 100/255, so that
/// difference images can be compared with each other. The colour map is cividis, which reads alike
/// with any kind of colour vision: J. Nunez, C. Anderton, R. Renslow, "Optimizing colormaps with
/// consideration for color vision deficiency", PLOS ONE 13(7), 2018.
vtkSmartPointer<vtkImageData> DifferencePicture(vtkImageData* floatPicture, vtkImageData* truth);

/// Height of the scale that DrawDifferenceScale draws [pixels].
constexpr int DifferenceScaleHeight = 56;

/// Draws the colour scale of difference images with its labels.
void DrawDifferenceScale(Canvas& canvas, int left, int bottom, int width);

/// Appends the colour scale below a difference image.
vtkSmartPointer<vtkImageData> WithDifferenceScale(vtkImageData* differencePicture);

}

#endif
