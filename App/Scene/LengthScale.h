#ifndef Varimarch_Scene_LengthScale_h
#define Varimarch_Scene_LengthScale_h

class vtkImageData;

namespace varimarch
{

/// Lengths of a look that are relative are right for a patient, and hold for a body of this size.
constexpr double BodySideMm = 200.0;

/// True if an image shows a patient, or a part of one, in its size: its reader says so, or its
/// values are Hounsfield units, and its longest side is from 20 mm to 3 m.
/// @param smallestValue  of the image
bool HasSizeOfPatient(vtkImageData* image, double smallestValue);

/// The factor from lengths for a patient to those for an image: 1 if it has the size of one, else
/// the side of a cube as large as the image, divided by BodySideMm. So a look draws about the same
/// picture of a cell, a mouse and a building.
double LengthFactor(vtkImageData* image, double smallestValue);

}

#endif
