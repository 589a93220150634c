#ifndef Varimarch_Viewer_ViewBars_h
#define Varimarch_Viewer_ViewBars_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/StudyTimes.h"

#include <QList>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace varimarch
{

class TimeSeries;

/// Chooses and plays the times of the scan that is shown; hidden if it has only one. A time is
/// shown until the next one has been read, so playing is slower where reading is.
class TimeBar : public QWidget
{
  Q_OBJECT

public:
  /// @param series  reads the times; must outlive this object
  TimeBar(SceneModel* model, const TimeSeries* series, QWidget* parent = nullptr);

  /// Play, previous time, next time, repeat, curve; they are off for a single time.
  QList<QAction*> Actions() const
  {
    return { this->play, this->previous, this->next, this->loop, this->curve };
  }

  TimeSpeed Speed() const;

signals:
  /// The user wants to see or to hide the curve of a value over time.
  void CurveWanted(bool shown);

private:
  void MakeActions();
  void AddButtons(QHBoxLayout* row);
  void AddSlider(QHBoxLayout* row);
  void Update(ScenePart part);
  void TakeVolume();
  void ListSpeeds(const LoadedTimes& times);
  void ShowTime();
  void Step(int times);
  void Choose(int time, const QString& name, int ofGesture);
  void Play(bool plays);
  void Await();
  void Advance();
  const LoadedTimes& Times() const;

  SceneModel* model;
  const TimeSeries* series;
  QAction* play;
  QAction* previous;
  QAction* next;
  QAction* loop;
  QAction* curve;
  QSlider* slider;
  QComboBox* speed; ///< the data is the number of times per second
  QLabel* text;
  QTimer timer; ///< until the next time is due
  int gesture = SceneModel::NoGesture;
};

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

/// Slab thickness of the slices, its blend mode, and the way back from turned slices.
class SlabBar : public QWidget
{
  Q_OBJECT

public:
  explicit SlabBar(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show(ScenePart part);

  SceneModel* model;
  QDoubleSpinBox* thickness; ///< [mm]
  QComboBox* blend;
  QToolButton* straighten;
};

class NumberSlider;

/// How slices show the volumes over the first one; hidden while there are none.
class FusionBar : public QWidget
{
  Q_OBJECT

public:
  explicit FusionBar(SceneModel* model, QWidget* parent = nullptr);

private:
  void Show(ScenePart part);

  SceneModel* model;
  NumberSlider* blend;
  QCheckBox* checkerboard;
};

}

#endif
