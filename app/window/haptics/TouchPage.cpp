// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/TouchPage.h"

#include "window/ActionToolTip.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

TouchPage::TouchPage(HapticSession& session, QWidget* parent)
    : PropertyList(parent), m_session(session), m_snap(tr("&Snap the device"), this) {
  setObjectName(QStringLiteral("touchPage"));
  m_snap.setCheckable(true);
  m_snap.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_M));
  prepare(m_snap, "snapDevice", "magnet",
          tr("Attract the tip of the device to what a click of the active tool would choose"));
  m_snap.setIconVisibleInMenu(false);  // the check mark stands there
  connect(&m_snap, &QAction::triggered, this, [this](bool isOn) {
    TouchSettings touch = m_session.touch();
    touch.isSnapping = isOn;
    m_session.setTouch(touch);
  });
  connect(this, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    TouchSettings touch = m_session.touch();
    handwheel::setProperty(touch, id, value);
    m_session.setTouch(touch);
    showTouch();  // also where it was brought between the limits to what it was
  });
  connect(&session, &HapticSession::touchChanged, this, &TouchPage::showTouch);
  showTouch();
}

void TouchPage::showTouch() {
  m_snap.setChecked(m_session.touch().isSnapping);
  setProperties(propertiesOf(m_session.touch()));
}

}  // namespace handwheel
