// What a program does with its streams and with full disks before anything else.
#pragma once

namespace nacre {

// A standard descriptor that was closed is taken up, so that no file opened later gets its number and what is
// said there; reading and writing it fails. Where a write cannot be done (the reader has gone, the file may
// not grow) it says so in place of ending the program.
void prepare_streams();

}  // namespace nacre
