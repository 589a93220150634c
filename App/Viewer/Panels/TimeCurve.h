#ifndef Varimarch_Viewer_TimeCurve_h
#define Varimarch_Viewer_TimeCurve_h

#include "Viewer/Model/SceneModel.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace varimarch
{

class TimeSeries;

/// A chart of the value at the crosshair of the slices over the times that are in memory. Ctrl+C
/// and the context menu copy it as a table.
class TimeCurve : public QWidget
{
  Q_OBJECT

public:
  /// @param series  must outlive this object
  TimeCurve(SceneModel* model, const TimeSeries* series, QWidget* parent = nullptr);

  /// The values as CSV: a title, and a line with time and value for each time in memory.
  QString Csv() const;

  QSize sizeHint() const override { return { 300, 110 }; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  /// The values by the number of the time; empty for times that are not in memory, and beside the
  /// volume.
  std::vector<std::optional<double>> Values() const;
  QString Unit() const;

  SceneModel* model;
  const TimeSeries* series;
};

}

#endif
