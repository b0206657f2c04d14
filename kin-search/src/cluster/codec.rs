//! How plans with ranges of ids, and with small tables of the client, are written for the scheduler.

use std::sync::Arc;

use ballista_core::serde::BallistaLogicalExtensionCodec;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::catalog::TableProvider;
use datafusion::common::{Result, TableReference, exec_err};
use datafusion::execution::TaskContext;
use datafusion::logical_expr::{Extension, LogicalPlan};
use datafusion_proto::logical_plan::LogicalExtensionCodec;

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
}
