// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "document/Property.h"
#include "haptics/WorkspaceMapping.h"

namespace handwheel {

class PropertyList;

// A mapping as a list of properties, with what suits the device.
std::vector<Property> mappingProperties(const WorkspaceMapping& mapping, const DeviceCapabilities& device);
// The mapping with one of them changed. An axis of the device that moved another one of the view changes places with
// it, so that each still moves one. What it does not know changes nothing.
WorkspaceMapping withProperty(WorkspaceMapping mapping, const std::string& id, const PropertyValue& value);

// How the device moves the tip: axes, scale, dead zone, clutch. Of the view's own part of the mapping it changes
// nothing.
class MappingForm : public QWidget {
  Q_OBJECT

 public:
  explicit MappingForm(QWidget* parent = nullptr);

  void setDevice(const DeviceCapabilities& device);
  void setMapping(const WorkspaceMapping& mapping);
  const WorkspaceMapping& mapping() const { return m_mapping; }

 signals:
  void mappingChanged(const handwheel::WorkspaceMapping& mapping);

 private:
  void refresh();

  PropertyList* m_list;
  DeviceCapabilities m_device;
  WorkspaceMapping m_mapping;
};

}  // namespace handwheel
