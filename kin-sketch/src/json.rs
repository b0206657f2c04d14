//! A body in JSON: the word `ground`, or the index of a link.

use serde::{Deserialize, Serialize};

use crate::sketch::{Body, LinkId};

#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "a body is \"ground\" or the index of a link")]
pub(crate) enum BodyJson {
    Ground(Ground),
    Link(LinkId),
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Ground {
    Ground,
}

impl From<BodyJson> for Body {
    fn from(body: BodyJson) -> Self {
        match body {
            BodyJson::Ground(Ground::Ground) => Self::Ground,
            BodyJson::Link(link) => Self::Link(link),
        }
    }
}

impl From<Body> for BodyJson {
    fn from(body: Body) -> Self {
        match body {
            Body::Ground => Self::Ground(Ground::Ground),
            Body::Link(link) => Self::Link(link),
        }
    }
}
