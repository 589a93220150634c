#ifndef Varimarch_Scene_DifferencePicture_h
#define Varimarch_Scene_DifferencePicture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

class Canvas;

/// Where two float pictures differ, as a byte picture: a pixel's colour tells the largest
/// difference of its channels on a logarithmic scale from 0.1 to 100 of 255, which is the same for
/// all pictures, so that they can be compared. The colours are those of cividis, which people with
/// any kind of colour vision see alike: J. Nunez, C. Anderton, R. Renslow, "Optimizing colormaps
/// with consideration for color vision deficiency", PLOS ONE 13(7), 2018.
vtkSmartPointer<vtkImageData> DifferencePicture(vtkImageData* floatPicture, vtkImageData* truth);

/// Height of what DrawDifferenceScale draws [pixels].
constexpr int DifferenceScaleHeight = 56;

/// The labelled scale of these colours.
void DrawDifferenceScale(Canvas& canvas, int left, int bottom, int width);

/// A difference picture with its scale below it, ready for a file.
vtkSmartPointer<vtkImageData> WithDifferenceScale(vtkImageData* differencePicture);

}

#endif
