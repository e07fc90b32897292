// SPDX-License-Identifier: Apache-2.0
#include "live/page_files.h"

namespace hawser::live {
namespace {

constexpr std::string_view kPage = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Hawser: no page in this program</title>
</head>
<body>
<main>
<h1>This program was built without its page</h1>
<p>The simulation runs, and its socket <code>/live</code> answers, but the page that shows it needs
node to be built, and node was not there.</p>
<p>In the folder of Hawser's sources:</p>
<pre>make view</pre>
<p>It installs what is missing, builds the page into the program, and opens it.</p>
</main>
</body>
</html>
)";

}  // namespace

std::span<const PageFile> page_files() {
    static const PageFile files[] = {
        {"/",
         "text/html; charset=utf-8",
         {reinterpret_cast<const unsigned char*>(kPage.data()), kPage.size()}}};
    return files;
}

}  // namespace hawser::live
