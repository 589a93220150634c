#ifndef Varimarch_Benchmarks_FeatureInputs_h
#define Varimarch_Benchmarks_FeatureInputs_h

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

// Conversions of a volume to other forms, whose costs are measured. The input has one component per
// point.

/// The volume with two components, both with the input's scalars.
vtkSmartPointer<vtkImageData> WithTwoComponents(vtkImageData* image);

/// The volume with four byte components for red, green, blue and opacity, all with the input's
/// scalars.
vtkSmartPointer<vtkImageData> WithFourColors(vtkImageData* image);

/// The volume as cell data, with one cell fewer than points on each axis.
vtkSmartPointer<vtkDataSet> OnCells(vtkImageData* image);

/// The volume on a rectilinear grid with the same coordinates.
vtkSmartPointer<vtkDataSet> OnRectilinearGrid(vtkImageData* image);

/// The volume with the points of a ball about the centre blanked.
vtkSmartPointer<vtkDataSet> WithBlankedBall(vtkImageData* image);

/// A mask that is 255 in a ball about the centre and 0 elsewhere, for use as a binary mask and as a
/// label map with one label.
vtkSmartPointer<vtkImageData> BallMask(vtkImageData* image);

/// A transfer function of scalar and gradient magnitude: opacity grows with both.
vtkSmartPointer<vtkImageData> OpacityOfScalarAndGradient();

}

#endif
