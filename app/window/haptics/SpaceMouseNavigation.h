// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mapping/WorkspaceMapping.h"
#include "panels/MessageBar.h"
#include "window/JobRunner.h"

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <functional>
#include <map>
#include <optional>

namespace handwheel {

class HapticSession;
class Viewport;

// Moves the view with all connected space mice; none needs to be chosen. Each space mouse is open in addition to the
// haptic device and is read sixty times a second. It has a thread that reads its connection, but no servo loop, because
// it exerts no force. A space mouse that is chosen as the haptic device moves the tip instead. Must be used on the
// window thread.
class SpaceMouseNavigation : public QObject {
  Q_OBJECT

 public:
  // The session and the viewport must outlive this object.
  SpaceMouseNavigation(HapticSession& session, Viewport& viewport, QThreadPool& pool, QObject* parent);
  ~SpaceMouseNavigation() override;

  // Searches for devices now, and again whenever a node "hidraw*" or "spnav.sock" appears in these folders or
  // disappears. No plugin is loaded while there is no such node.
  void watch(const QStringList& folders);
  // Switches the motion of the view on or off. speed: factor; 1: the default speed.
  void setMotion(bool isOn, double speed);
  // A receiver of the translation of the cap, such as the slides of a machine. displacement: in the scene, in units of
  // the height of the view. While a receiver is set, the view is not translated; empty: the view is translated again.
  using Taker = std::function<void(const Vec3& displacement)>;
  void setTaker(Taker taker) { m_taker = std::move(taker); }
  std::vector<std::string> names() const;  // names of the open devices

 signals:
  void changed();  // the set of open devices has changed
  void message(const handwheel::Message& message);

 private:
  struct OpenDevice {
    DeviceInfo listing;
    std::shared_ptr<Device> device;
    WorkspaceMapping mapping;
    double reach = 1.0;  // radius of the workspace of the cap, mm
  };
  // Motion of the model per second, along the axes of the view.
  struct Motion {
    Vec3 shift = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
    bool isRest() const { return shift.isZero(0.0) && turn.isZero(0.0); }
  };

  void readNodes();
  void followList();
  void followChoice();
  void tryOpening(const DeviceInfo& listing);
  void opened(const DeviceInfo& listing, std::shared_ptr<Device> device);
  void failed(const DeviceInfo& listing, const Error& error);
  template <class IsMeant>
  void drop(IsMeant isMeant);
  void move();
  Motion motion();
  Vec3 pivot() const;
  bool isChosen(const DeviceInfo& listing) const;

  HapticSession& m_session;
  Viewport& m_viewport;
  JobRunner m_jobs;
  QFileSystemWatcher m_folders;
  QTimer m_settling;  // delay of the next search: the permissions of a new node are set after its creation
  QStringList m_nodes;
  std::vector<OpenDevice> m_devices;
  std::map<std::string, int> m_tries;  // number of attempts to open each listed device, by address
  QTimer m_timer;
  QElapsedTimer m_sinceMove;
  std::optional<Vec3> m_pivot;  // pivot of the rotation while the view is moved
  Taker m_taker;
  bool m_isOn = true;
  double m_speed = 1.0;
};

}  // namespace handwheel
