#ifndef Varimarch_Viewer_TimeBar_h
#define Varimarch_Viewer_TimeBar_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/TimeSpeed.h"

#include <QList>
#include <QTimer>
#include <QWidget>

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QSlider;

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

}

#endif
