#ifndef Varimarch_Benchmarks_FeatureInputs_h
#define Varimarch_Benchmarks_FeatureInputs_h

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The same volume in other forms, for measuring the cost of each. The input has one component per
/// point.

/// Two components, both with the input's scalars.
vtkSmartPointer<vtkImageData> WithTwoComponents(vtkImageData* image);

/// Red, green, blue and opacity as bytes, each the input's scalar.
vtkSmartPointer<vtkImageData> WithFourColors(vtkImageData* image);

/// Cell data, with one cell fewer than points on each axis.
vtkSmartPointer<vtkDataSet> OnCells(vtkImageData* image);

/// The same grid with explicit coordinates.
vtkSmartPointer<vtkDataSet> OnRectilinearGrid(vtkImageData* image);

/// The volume with the points of a ball about the centre blanked.
vtkSmartPointer<vtkDataSet> WithBlankedBall(vtkImageData* image);

/// 255 in a ball about the centre, else 0: a binary mask, and a label map with one label.
vtkSmartPointer<vtkImageData> BallMask(vtkImageData* image);

/// A transfer function of scalar and gradient magnitude: opacity grows with both.
vtkSmartPointer<vtkImageData> OpacityOfScalarAndGradient();

}

#endif
