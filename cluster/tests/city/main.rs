//! Cities of made-up outlines: the bytes of `cga-city` from one process, from a cluster with lost machines, and through an S3 interface.

mod cluster;
mod embedded;
mod s3;
mod world;
