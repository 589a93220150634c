#ifndef Varimarch_Viewer_LabelPlaces_h
#define Varimarch_Viewer_LabelPlaces_h

#include <QRectF>

#include <optional>
#include <vector>

namespace varimarch
{

/// Places of labels in an image, none of which overlaps another.
class LabelPlaces
{
public:
  /// @param newTaken  places of other texts
  explicit LabelPlaces(const QSizeF& image, const std::vector<QRectF>& newTaken = {});

  /// Takes the free place for a label that is nearest to a wanted one. Empty if none is free.
  std::optional<QRectF> Take(const QRectF& wanted);

private:
  bool IsFree(const QRectF& place) const;
  /// The upper left corner of the nearest free place; empty if none is free.
  std::optional<QPointF> NearestFree(const QRectF& wanted) const;

  QRectF inside;
  std::vector<QRectF> taken;
  std::optional<QSizeF> tooLarge; ///< a size for which no place was free
};

}

#endif
