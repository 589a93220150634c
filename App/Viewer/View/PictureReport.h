#ifndef Varimarch_Viewer_PictureReport_h
#define Varimarch_Viewer_PictureReport_h

#include "Scene/ScenePipeline.h"

#include <QString>

namespace varimarch
{

/// Text in the corner of an image: its rendering time and its error.
/// @param seconds  until the whole image was rendered
QString PictureReport(ScenePipeline& pipeline, MapperKind kind, const Scene& scene, double seconds);

}

#endif
