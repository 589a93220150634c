#ifndef Varimarch_Benchmarks_FeatureInputs_h
#define Varimarch_Benchmarks_FeatureInputs_h

#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// The same volume in other forms, for measuring what each costs. All have the scalars of a volume
/// with one component on its points; a plain copy where that is enough.

/// Its scalars, twice.
vtkSmartPointer<vtkImageData> WithTwoComponents(vtkImageData* image);

/// Red, green, blue and opacity as bytes: the scalar in each.
vtkSmartPointer<vtkImageData> WithFourColors(vtkImageData* image);

/// One voxel fewer on each axis, each the value of a cell.
vtkSmartPointer<vtkDataSet> OnCells(vtkImageData* image);

/// The coordinates as they are, but written out.
vtkSmartPointer<vtkDataSet> OnRectilinearGrid(vtkImageData* image);

/// Without the points in a ball about the centre.
vtkSmartPointer<vtkDataSet> WithBlankedBall(vtkImageData* image);

/// 255 in a ball about the centre, else 0: a binary mask, and a label map with one label.
vtkSmartPointer<vtkImageData> BallMask(vtkImageData* image);

/// A transfer function of scalar and gradient magnitude: opacity grows with both.
vtkSmartPointer<vtkImageData> OpacityOfScalarAndGradient();

}

#endif
