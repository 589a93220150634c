#ifndef Varimarch_Testing_AnalyticPictures_h
#define Varimarch_Testing_AnalyticPictures_h

#include "Scene/Model/Scene.h"
#include "Support/AnalyticScenes.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <vector>

// Conversion of analytic scenes to volumes and scenes.

namespace varimarch
{

/// The volume of an analytic scene, as floats, which represent its values exactly.
vtkSmartPointer<vtkImageData> ImageOf(const AnalyticScene& analytic);

/// A scene with the analytic scene's transfer function, unshaded, seen obliquely, without early
/// termination.
Scene SceneOf(const AnalyticScene& analytic, int size);

/// Closed-form image of such a scene, for any camera.
std::vector<float> ClosedFormPicture(const AnalyticScene& analytic, const Scene& scene);

}

#endif
