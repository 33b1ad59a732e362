//! Cities of made-up outlines: the bytes of `cga-city` from one process, also with neighbours, from a cluster with lost machines, and through an S3 interface.

mod cluster;
mod compiled;
mod embedded;
mod lots;
mod neighbours;
mod s3;
mod world;
