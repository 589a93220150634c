#ifndef Varimarch_Viewer_PictureReport_h
#define Varimarch_Viewer_PictureReport_h

#include "Scene/ScenePipeline.h"

#include <QString>

namespace varimarch
{

/// What stands in the corner of a picture: its time, and how wrong it may be.
/// @param seconds  until its last pixel was there
QString PictureReport(ScenePipeline& pipeline, MapperKind kind, const Scene& scene, double seconds);

}

#endif
