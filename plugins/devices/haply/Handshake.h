// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handwheel::haply {

// Functions for the opening handshake of a WebSocket (RFC 6455, sections 1.3 and 4.1).

// Creates a handshake key from 16 random bytes, in base64. Each connection needs a new key.
std::string handshakeKey();
// Returns the answer that a server must give to a key. The answer proves that the server supports the protocol and has
// read the request.
std::string acceptFor(std::string_view key);

// Returns the HTTP request that opens a WebSocket.
std::string upgradeRequest(std::string_view host, std::string_view key);
// Returns true if the head of a server's response accepts the upgrade. The head reaches from "HTTP/1.1" to the empty
// line. The names of its fields may be in upper or lower case.
bool isUpgradeAccepted(std::string_view head, std::string_view key);

}  // namespace handwheel::haply
