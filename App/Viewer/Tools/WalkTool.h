#ifndef Varimarch_Viewer_WalkTool_h
#define Varimarch_Viewer_WalkTool_h

#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTool.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>

#include <glm/vec3.hpp>

#include <functional>
#include <map>

class QKeyEvent;

namespace varimarch
{

/// Walks through the volume as in a game: W, A, S, D or the arrow keys move the eye while they are
/// held, E and Q or the page keys raise and lower it, Shift makes it four times as fast, and a drag
/// of the mouse looks around. All from the first key until no key is held is one undo step. The
/// projection becomes a perspective.
class WalkTool : public MouseTool
{
  Q_DECLARE_TR_FUNCTIONS(WalkTool)

public:
  /// @param camera  the camera of the view, with its pose
  WalkTool(SceneModel* model, const ToolSurface& surface, std::function<Camera()> camera);

  /// Returns true if a key event is one of the tool's. Such keys are no shortcuts.
  bool TakeKey(QKeyEvent* event);

  /// Releases all keys, as when the view loses the focus.
  void Stand();

  bool Press(const QPointF& place) override;
  void Drag(const QPointF& place) override;
  void Release(const QPointF&) override {}
  void Cancel() override;

private:
  void Step();
  void Place(const Camera& placement);

  SceneModel* model;
  const ToolSurface& surface;
  std::function<Camera()> camera;
  std::map<int, bool> held; ///< keys, and whether Shift was held with them
  QTimer timer;             ///< timer of the steps
  QElapsedTimer sinceStep;
  QPointF pressed;
  Camera before; ///< the camera when the mouse was pressed
  int gesture = SceneModel::NoGesture;
};

/// The pose after a step to the right, up and forwards [mm]. Up is across the view and as near to
/// the camera's view-up as possible.
CameraPose Walked(const CameraPose& pose, const glm::dvec3& stepMm);

/// The pose that looks further to the right and further up, about the camera's view-up, but not
/// beyond 85 degrees from the horizon.
CameraPose LookingAround(const CameraPose& pose, double rightwardsDegrees, double upwardsDegrees);

}

#endif
