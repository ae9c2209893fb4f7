// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "base/Result.h"
#include "controls/property/PropertyList.h"

#include <QDialog>
#include <QLabel>
#include <functional>

namespace handwheel {

// A dialog that shows the properties of an action before it is done. The properties can be changed in it, and each
// change takes effect at once.
class PropertyDialog : public QDialog {
  Q_OBJECT

 public:
  struct Text {
    QString title, intro, button;
  };
  // The functions that return the displayed properties and change one of them. Only the dialog calls them. An error of
  // a change is displayed at its field.
  using Shown = std::function<std::vector<Property>()>;
  using Change = std::function<Status(const std::string& id, const PropertyValue& value)>;
  PropertyDialog(const Text& text, Shown shown, Change change, QWidget* parent);
  ~PropertyDialog() override;

  // Updates the fields. To be called when properties have changed without the dialog.
  void refresh() { m_list->setProperties(m_shown()); }
  void setIntro(const QString& text) { m_intro->setText(text); }
  // Adds a view of the result between the introduction and the fields. The dialog takes ownership.
  void addView(QWidget* view);
  void setLengthUnit(LengthUnit unit) { m_list->setLengthUnit(unit); }
  // Makes numbers take effect while they are being typed, not only when they are entered.
  void followTyping() { connect(m_list, &PropertyList::typed, this, &PropertyDialog::edit); }

 private:
  void edit(const std::string& id, const PropertyValue& value);

  Shown m_shown;
  Change m_change;
  QLabel* m_intro;
  PropertyList* m_list;
};

}  // namespace handwheel
