#ifndef Varimarch_Testing_AnalyticPictures_h
#define Varimarch_Testing_AnalyticPictures_h

#include "Scene/Scene.h"
#include "Support/AnalyticScenes.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <vector>

// Analytic scenes as anything that draws a scene takes them.

namespace varimarch
{

/// Its voxels as floats, which hold all of them exactly.
vtkSmartPointer<vtkImageData> ImageOf(const AnalyticScene& analytic);

/// Its transfer function, unshaded, seen obliquely; without early termination.
Scene SceneOf(const AnalyticScene& analytic, int size);

/// The closed form of the picture of such a scene, of any camera.
std::vector<float> ClosedFormPicture(const AnalyticScene& analytic, const Scene& scene);

}

#endif
