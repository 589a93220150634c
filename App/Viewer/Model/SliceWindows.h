#ifndef Varimarch_Viewer_SliceWindows_h
#define Varimarch_Viewer_SliceWindows_h

#include "Viewer/Model/SceneModel.h"

#include <QStringList>

namespace varimarch
{

/// Titles of the usual windows of the shown scan's modality, in the user's language; empty without
/// a scan. See Scene/Looks/Presets.h.
QStringList WindowTitles(const SceneModel& model);

/// True if the file of the shown scan recommends a window that its images share.
bool HasWindowOfFile(const SceneModel& model);

/// Shows the slices by the window of the histogram, whatever the file recommends.
void ChooseAutomaticWindow(SceneModel* model);

/// Shows the slices by the usual window of this number, from 1, or by that of the file or of the
/// histogram if it is 0. Does nothing if there is none.
void ChooseWindow(SceneModel* model, int number);

}

#endif
