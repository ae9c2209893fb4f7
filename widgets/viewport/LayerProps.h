// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkProp.h>
#include <vtkSmartPointer.h>
#include <vector>

class vtkRenderer;

namespace handwheel {

// The VTK props of one layer, which may be in a renderer. They are hidden together and keep their uploaded data.
class LayerProps {
 public:
  LayerProps() = default;
  ~LayerProps() { attach(nullptr); }
  LayerProps(const LayerProps&) = delete;
  LayerProps& operator=(const LayerProps&) = delete;

  // Moves all props to a renderer; null: removes them from the present one.
  void attach(vtkRenderer* renderer);
  void setVisible(bool visible);

  void add(vtkProp* prop);
  void remove(vtkProp* prop);
  // Shows or hides one prop. It is drawn only if the layer is visible, too.
  void show(vtkProp* prop, bool isShown);

 private:
  struct Entry {
    vtkSmartPointer<vtkProp> prop;
    bool isShown;
  };
  std::vector<Entry>::iterator find(const vtkProp* prop);

  vtkRenderer* m_renderer = nullptr;
  bool m_isVisible = true;
  std::vector<Entry> m_entries;  // translucent props are blended in this order
};

}  // namespace handwheel
