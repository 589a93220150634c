#ifndef Varimarch_Viewer_RegionPainter_h
#define Varimarch_Viewer_RegionPainter_h

#include "Scene/ValueGradientHistogram.h"
#include "Viewer/RegionEditor/RegionEditing.h"

#include <QImage>
#include <QPalette>
#include <QString>

#include <memory>

class QPainter;

namespace varimarch
{

/// The state that the editor of regions paints.
struct RegionPicture
{
  RegionLayout layout;
  std::vector<LookRegion> regions;
  std::shared_ptr<const ValueGradientHistogram> histogram; ///< null until it is counted
  QImage counts;                                           ///< picture of the histogram
  QString unit;
  int selected = -1;     ///< -1: none
  bool hasFocus = false; ///< the keyboard acts on the selected region
  QString reading;       ///< text of the readout
};

/// A histogram as shades of a colour: the logarithms of its counts, the gradient 0 at the bottom.
QImage PictureOfCounts(const ValueGradientHistogram& histogram, const QColor& ink);

/// Paints the editor in the colours of a palette, dark or light.
void PaintRegions(QPainter& painter, const RegionPicture& picture, const QPalette& palette);

}

#endif
