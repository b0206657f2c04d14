//! The encoding, for the scheduler and for executors, of plans with ranges of ids, with small tables of the client, and
//! with functions of declarations.

use std::sync::Arc;

use ballista_core::serde::{BallistaLogicalExtensionCodec, BallistaPhysicalExtensionCodec};
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::catalog::TableProvider;
use datafusion::common::{Result, TableReference, exec_datafusion_err, exec_err};
use datafusion::execution::TaskContext;
use datafusion::logical_expr::{Extension, LogicalPlan, ScalarUDF};
use datafusion::physical_plan::ExecutionPlan;
use datafusion_proto::logical_plan::LogicalExtensionCodec;
use datafusion_proto::physical_plan::{PhysicalExtensionCodec, PhysicalProtoConverterExtension};

use crate::function::{Functions, declaration_of};

use super::ids::Ids;
use super::tables;

/// The first byte of a table of ids, and of another table of the client.
const IDS: u8 = 0;
const ROWS: u8 = 1;

/// Ballista's own codec, the table of ids, and small tables of the client.
#[derive(Debug, Default)]
pub(super) struct Codec {
    others: BallistaLogicalExtensionCodec,
}

impl LogicalExtensionCodec for Codec {
    fn try_decode(&self, buf: &[u8], inputs: &[LogicalPlan], ctx: &TaskContext) -> Result<Extension> {
        self.others.try_decode(buf, inputs, ctx)
    }

    fn try_encode(&self, node: &Extension, buf: &mut Vec<u8>) -> Result<()> {
        self.others.try_encode(node, buf)
    }

    fn try_decode_table_provider(
        &self,
        buf: &[u8],
        _: &TableReference,
        _: SchemaRef,
        _: &TaskContext,
    ) -> Result<Arc<dyn TableProvider>> {
        // Files of tables have other messages.
        match buf.split_first() {
            Some((&IDS, ids)) => Ok(Arc::new(Ids::decode(ids)?)),
            Some((&ROWS, rows)) => tables::decode(rows),
            _ => exec_err!("a table of {} bytes is of no known kind", buf.len()),
        }
    }

    fn try_encode_table_provider(
        &self,
        table: &TableReference,
        node: Arc<dyn TableProvider>,
        buf: &mut Vec<u8>,
    ) -> Result<()> {
        let provider: &dyn std::any::Any = node.as_ref();
        match provider.downcast_ref::<Ids>() {
            Some(ids) => {
                buf.push(IDS);
                buf.extend(ids.encode());
            }
            None if tables::is_small(node.as_ref()) => {
                buf.push(ROWS);
                tables::encode(node.as_ref(), buf)?;
            }
            None => self.others.try_encode_table_provider(table, node, buf)?,
        }
        Ok(())
    }

    fn try_decode_file_format(
        &self,
        buf: &[u8],
        ctx: &TaskContext,
    ) -> Result<Arc<dyn datafusion::datasource::file_format::FileFormatFactory>> {
        self.others.try_decode_file_format(buf, ctx)
    }

    fn try_encode_file_format(
        &self,
        buf: &mut Vec<u8>,
        node: Arc<dyn datafusion::datasource::file_format::FileFormatFactory>,
    ) -> Result<()> {
        self.others.try_encode_file_format(buf, node)
    }

    fn try_decode_udf(&self, name: &str, buf: &[u8]) -> Result<Arc<ScalarUDF>> {
        decode(name, buf)
    }

    fn try_encode_udf(&self, node: &ScalarUDF, buf: &mut Vec<u8>) -> Result<()> {
        encode(node, buf);
        Ok(())
    }
}

/// Writes the text that declares the mechanism of a function. Other functions are known by their names, and nothing is
/// written.
fn encode(function: &ScalarUDF, buf: &mut Vec<u8>) {
    buf.extend(declaration_of(function).unwrap_or_default().bytes());
}

/// The function of this name of the mechanism that a text declares.
fn decode(name: &str, buf: &[u8]) -> Result<Arc<ScalarUDF>> {
    if buf.is_empty() {
        return exec_err!("there is no function `{name}`");
    }
    let text =
        std::str::from_utf8(buf).map_err(|error| exec_datafusion_err!("the declaration of `{name}`: {error}"))?;
    Functions::of_declaration(text, name)
}

/// Ballista's own codec of what executors do, and functions of declarations.
#[derive(Debug, Default)]
pub(super) struct PhysicalCodec {
    others: BallistaPhysicalExtensionCodec,
}

impl PhysicalExtensionCodec for PhysicalCodec {
    fn try_decode(
        &self,
        buf: &[u8],
        inputs: &[Arc<dyn ExecutionPlan>],
        ctx: &TaskContext,
        converter: &dyn PhysicalProtoConverterExtension,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        self.others.try_decode(buf, inputs, ctx, converter)
    }

    fn try_encode(
        &self,
        node: Arc<dyn ExecutionPlan>,
        buf: &mut Vec<u8>,
        converter: &dyn PhysicalProtoConverterExtension,
    ) -> Result<()> {
        self.others.try_encode(node, buf, converter)
    }

    fn try_decode_udf(&self, name: &str, buf: &[u8]) -> Result<Arc<ScalarUDF>> {
        decode(name, buf)
    }

    fn try_encode_udf(&self, node: &ScalarUDF, buf: &mut Vec<u8>) -> Result<()> {
        encode(node, buf);
        Ok(())
    }
}
