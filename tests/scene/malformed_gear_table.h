// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Mistakes in what a ship's deck has for wires, see malformed_table.h.

#include "good_scenes.h"

#include <string_view>

namespace hawser::scene::test {

struct Mistake {
    std::string_view scene;
    std::string_view patch;
    std::string_view path;
    std::string_view words;
};

// clang-format off
inline constexpr Mistake kGearMistakes[] = {
// --- deck gear ------------------------------------------------------------------------------
{kPendulum, R"([{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"bub","point":[0,0,0],"rated_load":1e6}]}])", "/stoppers/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0]}]}])", "/stoppers/0", "rated_load"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"outboard":[0,0,0]}]}])", "/stoppers/0", "no direction"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6},{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6}]}])", "/stoppers/1/name", "exists already"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"pitch":0.01}]}])", "/stoppers/0", "0.05"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"reach_":1}]}])", "/stoppers/0/reach_", "did you mean"},
{kPendulum, R"([{"op":"add","path":"/pins","value":[{"name":"pin","on":"bub","from":[0,0,0],"to":[0,0,1],"radius":0.1}]}])", "/pins/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/pins","value":[{"name":"pin","on":"quay","from":[0,0,1],"to":[0,0,1],"radius":0.1}]}])", "/pins/0", "shorter"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/pins","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"force":10}]}])", "/pins/0", "weight"},
{kPendulum, R"([{"op":"add","path":"/hooks","value":[{"name":"h","on":"bub","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay"}]}])", "/hooks/0", "loads"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bub","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/loads/0/body", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}],"latsch":1}]}])", "/hooks/0/latsch", "did you mean"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/chasers","value":[{"name":"c","on":"quay"}]}])", "/chasers/0", "rigid body"},
{kPendulum, R"([{"op":"add","path":"/chasers","value":[{"name":"c","on":"bub"}]}])", "/chasers/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/chasers","value":[{"name":"c","on":"quay","reech":1}]}])", "/chasers/0/reech", "did you mean"},
// --- posts ----------------------------------------------------------------------------------
{kPendulum, R"([{"op":"add","path":"/posts","value":[{"name":"pin","on":"bub","from":[0,0,0],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,1],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/to", "no length"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","to":[0,0,1],"radius":0.1}]}])", "/posts/0", "needs \"from\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/to", "leave out"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,1,1],"radius":0.1}]}])", "/posts/0/edge", "one 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,0],"radius":0.1}]}])", "/posts/0/edge", "one 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"radius":0.1}]}])", "/posts/0/edge", "no box"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"radius":2.5}]}])", "/posts/0/radius", "thinner"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","shapes":[{"name":"wall","kind":"box","half_size":[6,4,2]}]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"shape":"walls","sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of/shape", "wall"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","shapes":[{"name":"wall","kind":"box","half_size":[6,4,2]}]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"sharper_than":1},"radius":2.5}]}])", "/posts/0/edge_of", "thinner"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of", "no shape with edges"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"edge_of":{"sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of", "leave out"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"slides":1}]}])", "/posts/0/slides", "true or false"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0}]}])", "/posts/0/radius", "greater than 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"efficiency":0}]}])", "/posts/0", "above 0"},
};
// clang-format on

}  // namespace hawser::scene::test
