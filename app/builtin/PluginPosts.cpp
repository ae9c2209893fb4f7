// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "builtin/PluginPosts.h"

#include "cli/Messages.h"
#include "devices/PluginLoader.h"
#include "robot/posts/PostPlugin.h"

#include <QObject>

Q_DECLARE_INTERFACE(handwheel::PostPlugin, HANDWHEEL_POST_PLUGIN)

namespace handwheel {

std::vector<std::unique_ptr<PostProcessor>> pluginPosts() {
  std::vector<std::unique_ptr<PostProcessor>> posts;
  for (const std::string& folder : pluginFolders()) {
    for (const std::string& file : pluginFiles(folder + "/posts")) {
      PluginInfo listing;
      QObject* const object = loadPluginObject(file, HANDWHEEL_POST_PLUGIN, listing);
      if (listing.error) complain(fullSentenceFor(*listing.error));
      if (auto* const plugin = object ? qobject_cast<PostPlugin*>(object) : nullptr) {
        if (std::unique_ptr<PostProcessor> post = plugin->post()) posts.push_back(std::move(post));
      }
    }
  }
  return posts;
}

}  // namespace handwheel
