// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "document/Property.h"
#include "haptics/mapping/WorkspaceMapping.h"

namespace handwheel {

class PropertyList;

// Converts a mapping to properties, depending on the capabilities of the device.
std::vector<Property> mappingProperties(const WorkspaceMapping& mapping, const DeviceCapabilities& device);
// Returns the mapping with one property changed. When a device axis is assigned to another view axis, the two device
// axes swap, so that each still moves one view axis. Unknown properties change nothing.
WorkspaceMapping withProperty(WorkspaceMapping mapping, const std::string& id, const PropertyValue& value);

// A form for the mapping of a device: axes, scale, dead zone, clutch. It does not change
// WorkspaceMapping::sceneFromView.
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
